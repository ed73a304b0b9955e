// Mistake: measured values are one or more rows away from their joints and loads, in the whole table or from a lost or
// duplicated point on. Values without a matching row are left out.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

/// Assigns to every reading the measured values from `by` rows further down; removes readings without such a row
/// in their set-up.
void shift(int by, std::vector<Measurement>& readings);

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::shifted_rows
