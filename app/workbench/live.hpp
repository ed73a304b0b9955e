// Data of a running arm: its encoders, shown to all browsers, and its new readings, which join the existing ones.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class InputError;

/// Shows a posture (rad, m) and load [N] to all browsers, without storing it; `source` names its origin. Returns
/// {joints, load, source, tip: deflected tip of the current model in the world}, in the cell's units. Throws InputError
/// if the arm has no static equilibrium.
nlohmann::json showEncoders(Workbench& workbench, const Eigen::VectorXd& q, double load, const std::string& source);

/// Reports an error in the received data to all browsers.
void showLiveProblem(Workbench& workbench, const InputError& error, const std::string& source);

/// Queues readings, given as the text of a measurement file, until joinArrived(). Returns the number queued. Known ids
/// are skipped if `passes_known`, else refused. Throws InputError for these and for a bad file.
std::size_t takeArrived(Workbench& workbench, const std::string& text, const std::string& name, bool passes_known);

/// Adds the queued readings to the others if no job uses the readings, and begins the comparison of all.
void joinArrived(Workbench& workbench);

/// File that another program writes: a growing measurement table, or a table of joint columns (and a load), one row for
/// each reading of the encoders.
class WatchedFile {
 public:
  explicit WatchedFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads new rows; reports an error in them to all browsers once.
  void look(Workbench& workbench);

 private:
  void take(Workbench& workbench);

  std::filesystem::path file_;
  std::filesystem::file_time_type changed_ = {};
  std::uintmax_t size_ = 0;
};

}  // namespace tubeplan::app
