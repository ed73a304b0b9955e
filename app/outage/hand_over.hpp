// Hand-over of a shift: what it did, what the next one must know first, and what is left.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/outage/job_totals.hpp"

namespace tubeplan::app {

/// The shift that a hand-over is of. Without a date, the latest one with an event; without a name, any shift.
struct HandOverRequest {
  std::string shift, date;
};

/// Totals of all items by one of their properties.
struct TotalsBy {
  std::string by;  ///< "package and leg", "package", "leg" or "zone"
  std::vector<std::pair<std::string, ItemCounts>> rows;
};

/// Events of one person in the shift.
struct PersonsWork {
  std::string who;
  std::map<std::string, int> marks;  ///< number of marks that were not undone, by the name of the mark
  int confirmed = 0, wrong = 0;      ///< confirmations that found the tube that was meant, or another one
  int undone = 0;                    ///< marks of anybody that this person undid
};

/// An item with its latest mark that was not undone; the event is null for items without one.
struct MarkedItem {
  JobItem item;
  std::optional<JobEvent> event;
};

struct HandOver {
  std::optional<ShiftOfDay> shift;  ///< nothing if no shift that fits the request has an event
  std::vector<JobEvent> events;     ///< of the shift
  std::vector<PersonsWork> people;
  int later_events = 0;  ///< number of events after the end of the shift
  ItemCounts total;      ///< of all items at the end of the shift, as all that follows but `shifts`
  std::vector<TotalsBy> totals;
  std::vector<ShiftBalance> shifts;  ///< every shift with an event, in the order of their beginnings
  std::vector<MarkedItem> held;      ///< by decision or because the plan does not reach them
  std::vector<MarkedItem> retests;   ///< queued, the longest waiting first
  std::vector<JobEvent> wrong;       ///< confirmations of the shift that found another tube
};

/// Returns the hand-over of a shift. Throws InputError for a shift that the job does not have, and for a malformed
/// date.
[[nodiscard]] HandOver handOverOf(JobStore& store, const HandOverRequest& request);

}  // namespace tubeplan::app
