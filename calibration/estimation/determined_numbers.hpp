// Uncertainty of all parameters of an arm after an identification, both the fitted ones and those held fixed.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the covariance of every parameter about its value in the fitted arm, and of the base if there is a single
/// one. Parameters that were held fixed are included, with `held` as their prior; if the readings prefer another value
/// of a held parameter, its uncertainty is increased by the difference. `readings` are the fitted readings. Empty if
/// the model cannot be linearised at these readings.
[[nodiscard]] std::optional<ArmUncertainty> determinedNumbers(const Identification& fit,
                                                              const std::vector<Measurement>& readings,
                                                              const ArmUncertainty& held);

}  // namespace tubeplan::calibration
