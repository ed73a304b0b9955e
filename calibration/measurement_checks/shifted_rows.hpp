// What was measured stands a row off from the joints and loads that it was measured at: in the whole table, or from a
// point that was lost or doubled on. What has no partner is left out.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

/// Gives every reading what stands `by` rows further down.
void shift(int by, std::vector<Measurement>& readings);

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::shifted_rows
