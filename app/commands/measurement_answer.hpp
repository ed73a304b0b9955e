// Exit codes of commands that evaluate measurements.
#pragma once

#include "app/cli/command.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::app {

/// Returns the exit code of a command for a positive or negative result. A mistake in the measurements makes the result
/// negative, in all commands that evaluate measurements.
[[nodiscard]] inline ExitCode answerOver(const calibration::MeasurementChecks& checks, bool is_positive) {
  return is_positive && !calibration::firstMistake(checks) ? kDone : kNegativeAnswer;
}

}  // namespace tubeplan::app
