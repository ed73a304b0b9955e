// Checks whether the measurements suffice to accept or reject a model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

/// Reason why the measurements can neither confirm nor refute a model (`what`), and what would be needed to do so.
struct EvidenceProblem {
  std::string what, needed;
};

/// Returns a problem if there are too few postures for the number of parameters that the measurements determine, or too
/// few degrees of freedom to test the model; empty otherwise.
[[nodiscard]] std::optional<EvidenceProblem> findLackOfFreedom(const std::vector<Measurement>& measurements,
                                                               int degrees_of_freedom, int numbers_determined);

/// Returns a problem if the residuals are far smaller than the stated noise (lower tail of chi-square). The stated
/// noise is then too large, and would hide errors of the model. Empty otherwise.
[[nodiscard]] std::optional<EvidenceProblem> findOverstatedNoise(double chi2, int degrees_of_freedom);

}  // namespace tubeplan::calibration
