// The record of an outage's work: planned items, and an append-only log of what happened to them, in one SQLite file.
// docs/outage.md describes the tables.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/outage/database.hpp"
#include "app/outage/job_file.hpp"
#include "app/outage/log_entry.hpp"
#include "app/outage/marks.hpp"
#include "app/outage/tube_address.hpp"

namespace tubeplan::app {

/// One end of one tube in one package of work.
struct JobItem {
  std::int64_t id = 0;
  std::string package;
  TubeAddress tube;
  std::string excluded;               ///< reason for the tube's exclusion, such as "plugged"; empty if not excluded
  std::optional<std::int64_t> place;  ///< position in the visiting order; std::nullopt before planning
  const Mark* mark = nullptr;         ///< latest mark that was not undone; null if there is none
  std::int64_t last_event = 0;        ///< key of the latest event of this item; 0 if there is none
  std::string unreachable;            ///< reason why the plan does not reach the tube; empty if reached or not planned

  [[nodiscard]] ItemStanding standing() const;
  /// Returns true if a visit is due: the item is open or queued.
  [[nodiscard]] bool isDue() const;
  /// Returns true if the latest mark plugs this end of the tube.
  [[nodiscard]] bool isPlugged() const;
};

/// Returns the ends of tubes that marks have plugged.
[[nodiscard]] std::set<TubeAddress> pluggedEnds(const std::vector<JobItem>& items);

/// One entry of the log.
struct JobEvent {
  std::int64_t id = 0;
  std::string at;         ///< time in UTC, "2025-04-02T06:15:30Z"
  std::string person;     ///< person or program that recorded the event
  std::string kind;       ///< mark, confirm or undo
  std::int64_t item = 0;  ///< key of the item
  std::string package;
  TubeAddress tube;
  std::string value;   ///< name of the mark; "same" or the address of another tube for a confirmation
  std::string method;  ///< method of a confirmation
  std::string reason;
  std::optional<std::int64_t> undoes;  ///< key of the event that this event undoes
  bool is_undone = false;
};

/// Position of a tube's end in the sheet frame [m], and the state that the job began with.
struct TubeEnd {
  TubeAddress tube;
  double x = 0, y = 0;
  std::string state;
};

/// The sheet of one leg.
struct JobSheet {
  std::string generator;
  JobLeg leg;
  std::string fingerprint;
  double pitch = 0;  ///< [m]
};

class JobStore {
 public:
  /// Creates the record of a job: reads its cells, selects the tubes of every package, and writes the complete file or
  /// none. Returns notes on ignored content of the tables. Throws InputError for input that the
  /// readers of cells, tables or selections reject.
  static std::vector<std::string> create(const JobFile& job, const std::string& path);

  /// Opens a record; one that is only read (Database::Mode::kRead) may be write-protected. Throws InputError for a file
  /// that is not the record of a job, or has another format.
  explicit JobStore(const std::string& path, Database::Mode mode = Database::Mode::kOpen);

  [[nodiscard]] const JobFile& job() const { return job_; }

  /// Returns all items in the order in which they are to be visited: by package, steam generator and leg, then by place
  /// in the visiting order or, for items without a place, by row and column.
  [[nodiscard]] std::vector<JobItem> items();
  /// Returns the items of one end of a tube, in the order of their packages.
  [[nodiscard]] std::vector<JobItem> itemsOf(const TubeAddress& tube);
  /// Returns the events later than the event `after`, in their order; all events for 0.
  [[nodiscard]] std::vector<JobEvent> events(std::int64_t after = 0);
  /// Returns the key of the latest event; 0 if there is none.
  [[nodiscard]] std::int64_t lastEvent();
  [[nodiscard]] std::vector<JobEvent> eventsOf(std::int64_t item);
  [[nodiscard]] std::vector<JobSheet> sheets();
  /// Returns one end of a tube, which must be in the record.
  [[nodiscard]] TubeEnd endOf(const TubeAddress& tube);
  /// Returns all ends of tubes on one leg, in the order of rows and columns.
  [[nodiscard]] std::vector<TubeEnd> endsOf(const std::string& generator, tubesheets::Leg leg);
  /// Returns the text of the work list from which a package was read; empty if it was not read from a list.
  [[nodiscard]] std::string listOf(const std::string& package, const std::string& generator, tubesheets::Leg leg);

  /// Returns the drawing data of a leg's sheet, as JSON: {viewed_from, hole_diameter_m, manway: direction [x, y] or
  /// null}; an empty object for a record without it.
  [[nodiscard]] std::string drawingOf(const LegName& leg);
  /// Return the latest plan of the job, and the time at which it was recorded; empty before the first plan.
  [[nodiscard]] std::string plan() { return noteOf("plan"); }
  [[nodiscard]] std::string plannedAt() { return noteOf("planned_at"); }
  /// Records the plan of the job, as jobPlanJson() returns it, in place of the one before.
  void setPlan(const std::string& plan);

  /// Calls `work` in a transaction, so that the data it reads cannot change before it writes.
  void transact(const std::function<void()>& work) { database_.transact(work); }

  /// Record an event and return its key. Called within transact().
  std::int64_t addMark(const JobItem& item, const Mark& mark, const EventEntry& entry);
  std::int64_t addConfirmation(const JobItem& item, ConfirmationMethod method, const std::string& value,
                               const EventEntry& entry);
  std::int64_t addUndo(const JobEvent& event, const EventEntry& entry);

  /// Sets the visiting order of items that were planned together. Called within transact().
  void setPlaces(const std::vector<std::int64_t>& items_in_order);
  /// Sets the reason why an item cannot be reached; empty if it can be reached. Called within transact().
  void setUnreachable(std::int64_t item, const std::string& reason);

 private:
  /// Returns the value of a key of the table `job`; empty if there is none.
  [[nodiscard]] std::string noteOf(const std::string& key);
  std::int64_t addEvent(const std::string& kind, std::int64_t item, const std::string& value, const std::string& method,
                        const EventEntry& given, std::optional<std::int64_t> undoes);

  Database database_;
  JobFile job_;
};

}  // namespace tubeplan::app
