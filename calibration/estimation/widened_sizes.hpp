// Intervals of effects' sizes over all sizes that explain the readings equally well (size_modes.hpp).
#pragma once

#include "calibration/estimation/identified_numbers.hpp"

namespace tubeplan::calibration {

/// Widens the intervals, and says so in the numbers' notes.
void widenSizes(const FittedModel& model, Identification& result);

}  // namespace tubeplan::calibration
