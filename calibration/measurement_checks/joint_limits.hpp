// Joint readings beyond their limits: by whole turns, which do not change the pose, or by a very small amount.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns true if a joint's reading `q` [rad or m] is beyond a limit by more than both its noise and a thousandth of
/// the joint's range. Limits are rounded, and a joint at its stop may read slightly more.
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// Returns the reading [rad] moved by one whole turn, if it is then within both limits; nullopt otherwise, and for a
/// prismatic joint.
[[nodiscard]] std::optional<double> oneTurnBack(const deflection::Joint<double>& joint, double q);

/// Returns a remark on readings that are beyond a limit by more than their noise but accepted by isPastLimit().
[[nodiscard]] std::optional<MeasurementCheck> hairPastLimits(const CheckedReadings& checked);

/// Moves readings beyond the limits of a joint by one turn, if this brings all of these readings within the limits. An
/// example is an encoder that reads 0 to 360 deg with limits of -180 and 180 deg. Returns nullopt if there is no such
/// joint.
std::optional<MeasurementCheck> unwindJoints(CheckedReadings& checked);

}  // namespace tubeplan::calibration
