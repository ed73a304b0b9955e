// Claims of competing models about what is missing, with probabilities that sum to one.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Claim of one model, or its claim if one of its terms is only similar to an unknown effect.
struct Claim {
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;         ///< probability that the noise is larger than stated and nothing else remains
  const CompetingModel* model = nullptr;  ///< null for a similarity; the most probable of several models
};

/// Adds the probability of claim `one` to claim `to`.
void mixIn(const Claim& one, Claim& to);

/// Returns all claims of the models, with probabilities that sum to one. Models without a fit are penalised by the
/// median loss of the fitted ones.
[[nodiscard]] std::vector<Claim> claimsOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
