// Whether readings can bear a verdict on a model at all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// Why readings can bear no verdict, and what would be needed.
struct EvidenceProblem {
  std::string what, needed;
};

/// Too few postures or degrees of freedom beside the numbers that the readings determine.
[[nodiscard]] std::optional<EvidenceProblem> findLackOfFreedom(const std::vector<Measurement>& readings,
                                                               int degrees_of_freedom, int numbers_determined);

/// A fit far better than the stated noise allows (the lower tail of chi-square): the noise is stated too large, so
/// that nothing could be seen beside it.
[[nodiscard]] std::optional<EvidenceProblem> findOverstatedNoise(double chi2, int degrees_of_freedom);

}  // namespace tubeplan::calibration
