// Initial base poses for a fit: one for every set-up that the readings name.
#pragma once

#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns the arm with a base pose at `X_WB` for every set-up that the readings name, in order of first appearance.
[[nodiscard]] PlacedArm placeForReadings(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool is_known,
                                         const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
