// Joint readings beyond their limits: by whole turns, which change no pose, or by a very small amount.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns true if a joint's reading [rad or m] is beyond a limit by more than its noise and a thousandth of the range.
/// Limits are rounded, and a joint at its stop may read slightly more.
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// Returns the reading moved by a whole turn into both limits [rad]; nothing if it is still outside or the joint is a
/// slide.
[[nodiscard]] std::optional<double> oneTurnBack(const deflection::Joint<double>& joint, double q);

/// Returns a remark on readings that are beyond a limit by more than their noise but accepted by isPastLimit().
[[nodiscard]] std::optional<MeasurementCheck> hairPastLimits(const CheckedReadings& checked);

/// Moves readings beyond their limits by a turn, for joints where this brings all of them within: encoders read 0 to
/// 360 deg, while the limits are -180 and 180. Returns nothing if there is no such joint.
std::optional<MeasurementCheck> unwindJoints(CheckedReadings& checked);

}  // namespace tubeplan::calibration
