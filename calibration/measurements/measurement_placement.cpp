#include "calibration/measurements/measurement_placement.hpp"

#include <algorithm>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

PlacedArm placeForMeasurements(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool is_known,
                               const std::vector<Measurement>& measurements) {
  PlacedArm placed{arm, {}};
  for (const auto& measurement : measurements) {
    const bool is_there = std::any_of(placed.base_poses.begin(), placed.base_poses.end(),
                                      [&](const BasePose& p) { return p.setup == measurement.setup; });
    if (!is_there) placed.base_poses.push_back({measurement.setup, X_WB, is_known});
  }
  if (placed.base_poses.empty()) placed.base_poses.push_back({"", X_WB, is_known});
  placed.shows_tool_turn = std::ranges::any_of(measurements, seesToolTurn);
  return placed;
}

}  // namespace tubeplan::calibration
