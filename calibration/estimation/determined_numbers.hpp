// How well all of an arm's numbers are known by a campaign: those that were fitted, and those that were held.
#pragma once

#include <optional>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

/// Returns the covariance of every number about its value in the fitted arm, numbers that were held among them with
/// `held` for their prior, and of the base where there is one. Held numbers whose most probable value is another by the
/// readings are as much more uncertain. Nothing where the model cannot be linearised at `readings`, which were fitted.
[[nodiscard]] std::optional<ArmUncertainty> determinedNumbers(const Identification& fit,
                                                              const std::vector<Measurement>& readings,
                                                              const ArmUncertainty& held);

}  // namespace tubeplan::calibration
