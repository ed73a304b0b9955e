// What a command that takes readings answers to scripts.
#pragma once

#include "app/cli/command.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Returns the exit code of a command by what it found, which counts for nothing over a mistake in its readings. One
/// rule for all that take readings.
[[nodiscard]] inline ExitCode answerOver(const calibration::MeasurementChecks& checks, bool is_positive) {
  return is_positive && !calibration::grossMistake(checks) ? kDone : kNegativeAnswer;
}

}  // namespace tubeplan::app
