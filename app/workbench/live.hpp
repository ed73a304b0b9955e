// Data from a running arm: encoder readings, shown in all browsers, and new measurements, added to the loaded
// measurements.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class InputError;

/// Shows a posture `q` [rad, m] and a load [N] in all browsers without storing them; `source` names the sender. Returns
/// {joints, load, source, tip: deflected tip of the current model in the world frame}, in the cell's units. Throws
/// InputError if the arm has no static equilibrium.
nlohmann::json showEncoders(Workbench& workbench, const Eigen::VectorXd& q, double load, const std::string& source);

/// Reports an error in received data to all browsers.
void showLiveProblem(Workbench& workbench, const InputError& error, const std::string& source);

/// Queues measurements, given as the text of a measurement file, to be added by joinArrived(). Returns the number of
/// queued measurements. Measurements with known ids are skipped if `passes_known`, otherwise refused. Throws InputError
/// for refused ids and for a faulty file.
std::size_t takeArrived(Workbench& workbench, const std::string& text, const std::string& name, bool passes_known);

/// Adds the queued measurements to the loaded measurements unless a job is running, and begins the comparison of all.
void joinArrived(Workbench& workbench);

/// File that another program writes: a growing measurement table, or a table of encoder readings with one row per
/// posture and columns for the joints and, optionally, the load.
class WatchedFile {
 public:
  explicit WatchedFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads the file if it has changed. Reports an error in the file to all browsers once per change.
  void look(Workbench& workbench);

 private:
  void take(Workbench& workbench);

  std::filesystem::path file_;
  std::filesystem::file_time_type changed_ = {};
  std::uintmax_t size_ = 0;
};

}  // namespace tubeplan::app
