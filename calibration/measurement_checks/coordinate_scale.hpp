// Mistake: one coordinate is multiplied by a factor that is no ratio of units, such as half a travel or a gear ratio.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::coordinate_scale {

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::coordinate_scale
