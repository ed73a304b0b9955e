// Exit codes of commands that take readings.
#pragma once

#include "app/cli/command.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Returns the exit code of a command by its result; a mistake in the readings overrides the result. Used by all
/// commands that take readings.
[[nodiscard]] inline ExitCode answerOver(const calibration::MeasurementChecks& checks, bool is_positive) {
  return is_positive && !calibration::grossMistake(checks) ? kDone : kNegativeAnswer;
}

}  // namespace tubeplan::app
