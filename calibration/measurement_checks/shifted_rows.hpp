// Mistake: measured values are written one or more rows above or below their joints and loads, in the whole table or
// after a lost or duplicated point. Measurements without a matching row are excluded.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

/// Assigns to every measurement the measured values from `by` rows further down; removes measurements without such a
/// row in their set-up.
void shift(int by, std::vector<Measurement>& measurements);

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::shifted_rows
