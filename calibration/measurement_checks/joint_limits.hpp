// Checks of joint readings that lie beyond the joint limits, either by a whole turn, which does not change the pose, or
// by a very small amount.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns true if a joint's reading `q` [rad or m] is beyond a limit by more than both its noise and a thousandth of
/// the joint's range. The margin is needed because limits are rounded, and a joint at its stop may read slightly more.
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// Returns the joint reading [rad] shifted by one whole turn, if it is then within both limits; nullopt otherwise, and
/// for a prismatic joint.
[[nodiscard]] std::optional<double> shiftedByOneTurn(const deflection::Joint<double>& joint, double q);

/// Returns a remark on measurements that are beyond a limit by more than their noise, but not by enough for
/// isPastLimit().
[[nodiscard]] std::optional<MeasurementCheck> slightlyPastLimits(const CheckedMeasurements& checked);

/// Moves the measurements that are beyond a joint's limits by one turn, if this brings all of them within the limits,
/// and returns a remark on them; nullopt if there is no such joint. An example is an encoder that reads 0 to 360 deg
/// with limits of -180 and 180 deg.
std::optional<MeasurementCheck> unwindJoints(CheckedMeasurements& checked);

}  // namespace tubeplan::calibration
