// Uncertainty of all of an arm's numbers after a campaign: of those that were fitted, and of those that were held.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the covariance of every number about its value in the fitted arm, including numbers that were held, with
/// `held` as their prior, and of the base if there is one. If the readings prefer another value of a held number, its
/// uncertainty is increased by that difference. `readings` are those that were fitted; nothing if the model cannot be
/// linearised at them.
[[nodiscard]] std::optional<ArmUncertainty> determinedNumbers(const Identification& fit,
                                                              const std::vector<Measurement>& readings,
                                                              const ArmUncertainty& held);

}  // namespace tubeplan::calibration
