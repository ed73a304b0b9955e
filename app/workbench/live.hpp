// A running arm beside the workbench: all browsers see where its encoders say it is, and readings that it takes join
// those that are there.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

class InputError;

/// Tells all browsers a posture (rad, m) and load [N]; `source` says where it is from. Nothing of it is kept. Returns
/// {joints, load, source, tip: where the current model has the deflected tip, in the world}, in the cell's units.
/// Throws InputError where the arm does not come to rest.
nlohmann::json showEncoders(Workbench& workbench, const Eigen::VectorXd& q, double load, const std::string& source);

/// Tells all browsers what is wrong with what came.
void showLiveProblem(Workbench& workbench, const InputError& error, const std::string& source);

/// Readings as the text of a measurement file: they wait until joinArrived(). How many wait is returned. Ids that are
/// there already are passed over where `passes_known`, else refused. Throws InputError for these and for a bad file.
std::size_t takeArrived(Workbench& workbench, const std::string& text, const std::string& name, bool passes_known);

/// Once no job works on the readings, those that wait join them, and the comparison of all is begun.
void joinArrived(Workbench& workbench);

/// A file that another program writes: a measurement table to which rows are added, or a table of joint columns (and a
/// load), one row for each time that the encoders were read.
class WatchedFile {
 public:
  explicit WatchedFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Takes what is new; what is wrong with it is sent to all browsers, once.
  void look(Workbench& workbench);

 private:
  void take(Workbench& workbench);

  std::filesystem::path file_;
  std::filesystem::file_time_type changed_ = {};
  std::uintmax_t size_ = 0;
};

}  // namespace tubeplan::app
