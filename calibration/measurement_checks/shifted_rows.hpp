// Mistake of measured values in another row than their joints and loads: in the whole table, or from a lost or doubled
// point on. Values without a partner are left out.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

/// Gives every reading the measured values from `by` rows further down.
void shift(int by, std::vector<Measurement>& readings);

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::shifted_rows
