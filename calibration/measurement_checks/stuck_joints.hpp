// Mistake: the reading of one joint does not change in consecutive measurements although the joint moves, because its
// encoder or its column in the log stood still. Copies of all joints are found by stale_joints.hpp.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a mistake for each run of measurements in which a joint has exactly the same reading, which the model
/// refutes: the measured positions have gross errors, and other values of this joint alone remove them. `found` is the
/// model of a robust fit.
[[nodiscard]] std::vector<MeasurementCheck> stuckJoints(const CheckedMeasurements& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
