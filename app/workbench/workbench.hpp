// The workbench: the situation that all browsers share, the jobs that change it and the folder that is open.
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
  std::string cell;                       ///< file, or a project
  std::vector<std::string> measurements;  ///< files, taken together
  std::string truth;                      ///< a cell's file, to touch with; empty: none
  std::string folder;                     ///< empty: the cell's
  std::string state;                      ///< folder where the session is kept; empty: it is not
  bool fresh = false;                     ///< a kept session is put aside
  int most_listeners = 16;
};

class Workbench {
 public:
  /// Reads what is named. Throws InputError.
  explicit Workbench(const WorkbenchOptions& options);

  [[nodiscard]] Session session() const;

  /// Changes the situation, as one step for all who look at it, and sends it to everybody. A step that returns false
  /// changes nothing; whether it did is returned.
  bool change(const std::function<bool(Session&)>& step);

  /// Instead of all there is, unless a job works on it: with that cell's session kept from now on, an earlier one of it
  /// put aside. False where one does.
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
  Jobs jobs_;  ///< last: its thread ends before what it works on
};

/// The situation of a cell, or of a project, just opened. Throws InputError.
[[nodiscard]] Session openCell(const std::string& file, const std::string& truth);

}  // namespace tubeplan::app
