// Uncertainty of all parameters of an arm after an identification, including those that the fit held fixed.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the covariance of all parameters about their values in the fitted arm, and of the base if there is only one.
/// Parameters that the fit held fixed are included, with `held` as their prior; if the measurements prefer another
/// value of such a parameter, the difference increases its uncertainty. `measurements` are the fitted measurements.
/// Empty if the model cannot be evaluated at these measurements.
[[nodiscard]] std::optional<ArmUncertainty> determinedNumbers(const Identification& fit,
                                                              const std::vector<Measurement>& measurements,
                                                              const ArmUncertainty& held);

}  // namespace tubeplan::calibration
