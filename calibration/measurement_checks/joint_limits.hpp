// Joint readings past their limits: by whole turns, which change no pose, or by a hair.
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns whether a joint's reading [rad or m] lies past a limit by more than its noise and a thousandth of the range:
/// limits are rounded, and a joint at its stop reads a hair past it.
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// Returns a reading past a limit taken a whole turn back within both; nothing where that is not within, or the joint
/// slides.
[[nodiscard]] std::optional<double> oneTurnBack(const deflection::Joint<double>& joint, double q);

/// Readings past a limit by a hair, which count: by more than their noise, but isPastLimit() lets them be.
[[nodiscard]] std::optional<MeasurementCheck> hairPastLimits(const CheckedReadings& checked);

/// Takes readings past their limits a turn back, of each joint of which all of these then lie within: encoders read 0
/// to 360 deg where the limits are -180 and 180. Nothing where there is no such joint.
std::optional<MeasurementCheck> unwindJoints(CheckedReadings& checked);

}  // namespace tubeplan::calibration
