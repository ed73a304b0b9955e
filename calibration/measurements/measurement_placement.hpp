// Initial base poses for a fit: one for every set-up that the measurements name.
#pragma once

#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns the arm with a base pose at `X_WB` for every set-up that the measurements name, in order of first
/// appearance.
[[nodiscard]] PlacedArm placeForMeasurements(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool is_known,
                                             const std::vector<Measurement>& measurements);

}  // namespace tubeplan::calibration
