// From a cell as read to what the planner works on.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/readers/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Throws InputError where the cell has no tube sheet or no calibration tool; `purpose` continues "needed to ...".
[[nodiscard]] planner::Workcell workcellOf(const Cell& cell, const std::string& purpose);

/// {"position": [3], "rpy": [3]} in file units.
[[nodiscard]] nlohmann::json poseJson(const Eigen::Isometry3d& X, const Units& units);

/// Joint readings in file units to the last bit: rounded ones would move the tip by more than a plan promises.
[[nodiscard]] nlohmann::json jointValuesJson(const Eigen::VectorXd& q, const Cell& cell);

/// One number, a length unless said otherwise, in file units.
[[nodiscard]] inline double lengthOf(double metres, const Units& units) {
  return units.toFile(metres, dimension::kLength);
}
[[nodiscard]] inline double angleOf(double radians, const Units& units) {
  return units.toFile(radians, dimension::kAngle);
}

}  // namespace tubeplan::app
