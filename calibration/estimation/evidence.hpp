// Checks whether readings allow a verdict on a model at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// Reason why readings allow no verdict, and what is needed.
struct EvidenceProblem {
  std::string what, needed;
};

/// Returns a problem if there are too few postures, or too few degrees of freedom beside the numbers that the readings
/// determine.
[[nodiscard]] std::optional<EvidenceProblem> findLackOfFreedom(const std::vector<Measurement>& readings,
                                                               int degrees_of_freedom, int numbers_determined);

/// Returns a problem if a fit is far better than the stated noise allows (the lower tail of chi-square). The noise is
/// then stated too large, and hides every other error.
[[nodiscard]] std::optional<EvidenceProblem> findOverstatedNoise(double chi2, int degrees_of_freedom);

}  // namespace tubeplan::calibration
