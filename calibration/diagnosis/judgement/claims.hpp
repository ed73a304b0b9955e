// Claims of competing models about which causes are missing, with probabilities that sum to one.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Causes that are missing according to one model, or according to the model without a term that may only resemble an
/// unknown effect.
struct Claim {
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;  ///< probability that the noise is larger than stated and nothing else remains
  /// Most probable model with this claim; null if a term was left out.
  const CompetingModel* model = nullptr;
};

/// Merges claim `one` into claim `to`: adds up the probabilities, and averages the conditional probabilities with them
/// as weights.
void mixIn(const Claim& one, Claim& to);

/// Returns all claims of the models, with probabilities that sum to one. Models without a fit are penalised by the
/// median loss of evidence of the fitted models.
[[nodiscard]] std::vector<Claim> claimsOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
