// Workbench: the session shared by all browsers, the jobs that change the session, and the opened folder.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/events.hpp"
#include "app/workbench/jobs.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "app/workbench/opened_folder.hpp"
#include "app/workbench/session.hpp"
#include "app/workbench/session_keeper.hpp"

namespace tubeplan::app {

struct WorkbenchOptions {
  std::string cell;                            ///< cell file or project file
  std::vector<std::string> measurement_files;  ///< measurement files that form one set
  std::string truth;                           ///< cell file of the true arm for simulated touches; empty if none
  std::string folder;                          ///< opened folder; if empty, the folder of the cell file
  std::string state;                           ///< folder in which the session is stored; if empty, it is not stored
  bool fresh = false;                          ///< true to rename a stored session instead of resuming it
  int most_listeners = 16;
};

class Workbench {
 public:
  /// Opens the files named in the options, or resumes the kept session. Throws InputError.
  explicit Workbench(const WorkbenchOptions& options);

  [[nodiscard]] Session session() const;

  /// Applies `step` to the session atomically and sends the change to all browsers. Returns the result of `step`; false
  /// means that nothing changed. The change can be undone unless `is_noted` is false.
  bool change(const std::function<bool(Session&)>& step, bool is_noted = true);

  /// Replaces the session unless a job is running, and keeps the session of the new cell from now on. A session kept
  /// earlier for the new cell is renamed. Returns false if a job is running.
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
  Jobs jobs_;  ///< must be the last member, so that the job thread ends before its data is destroyed
};

/// Returns the session of a newly opened cell or project. Throws InputError.
[[nodiscard]] Session openCell(const std::string& file, const std::string& truth);

}  // namespace tubeplan::app
