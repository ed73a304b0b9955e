// Checks that readings suffice for a verdict on a model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// Reason why readings allow no verdict, and what would be needed for one.
struct EvidenceProblem {
  std::string what, needed;
};

/// Returns a problem if there are too few postures for the number of parameters that the readings determine, or too few
/// degrees of freedom to test the model; otherwise empty.
[[nodiscard]] std::optional<EvidenceProblem> findLackOfFreedom(const std::vector<Measurement>& readings,
                                                               int degrees_of_freedom, int numbers_determined);

/// Returns a problem if the fit is far better than the stated noise allows (lower tail of chi-square): the stated noise
/// is then too large and hides every other error. Otherwise empty.
[[nodiscard]] std::optional<EvidenceProblem> findOverstatedNoise(double chi2, int degrees_of_freedom);

}  // namespace tubeplan::calibration
