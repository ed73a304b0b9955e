// Workbench: the session shared by all browsers, the jobs that change it and the opened folder.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/events.hpp"
#include "app/workbench/jobs.hpp"
#include "app/workbench/opened_folder.hpp"
#include "app/workbench/reading_sets.hpp"
#include "app/workbench/session.hpp"
#include "app/workbench/session_keeper.hpp"

namespace tubeplan::app {

struct WorkbenchOptions {
  std::string cell;                       ///< file of a cell or project
  std::vector<std::string> measurements;  ///< files, taken together
  std::string truth;                      ///< cell file of the true arm for simulated touches; empty: none
  std::string folder;                     ///< empty: the cell's folder
  std::string state;                      ///< folder where the session is kept; empty: it is not kept
  bool fresh = false;                     ///< true: a kept session is renamed and not continued
  int most_listeners = 16;
};

class Workbench {
 public:
  /// Reads the named files. Throws InputError.
  explicit Workbench(const WorkbenchOptions& options);

  [[nodiscard]] Session session() const;

  /// Applies a step to the session atomically and sends the change to all browsers. Returns the step's result; false
  /// means that nothing changed.
  bool change(const std::function<bool(Session&)>& step);

  /// Replaces the whole session unless a job works on it, and keeps the session of the new cell from now on; an earlier
  /// kept one is renamed. Returns false if a job is running.
  bool replace(Session session);

  [[nodiscard]] const SessionKeeper& keeper() const { return keeper_; }
  [[nodiscard]] const OpenedFolder& folder() const { return folder_; }
  [[nodiscard]] Events& events() { return events_; }
  [[nodiscard]] const Events& events() const { return events_; }
  [[nodiscard]] Arrivals& arrivals() { return arrivals_; }
  [[nodiscard]] Jobs& jobs() { return jobs_; }
  [[nodiscard]] const Jobs& jobs() const { return jobs_; }

 private:
  mutable std::mutex mutex_;
  Session session_;
  OpenedFolder folder_;
  SessionKeeper keeper_;
  Events events_;
  Arrivals arrivals_;
  Jobs jobs_;  ///< last member, so that its thread ends before the data it works on
};

/// Returns the session of a newly opened cell or project. Throws InputError.
[[nodiscard]] Session openCell(const std::string& file, const std::string& truth);

}  // namespace tubeplan::app
