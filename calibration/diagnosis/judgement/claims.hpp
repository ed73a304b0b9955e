// Claims of competing models about which causes are missing, with probabilities that sum to one.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Set of missing causes according to one model. If a term of the model may only resemble an unknown effect, a second
/// claim omits this term.
struct Claim {
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;  ///< probability that the noise is larger than stated and nothing else remains
  /// Most probable model with this claim; null if the claim leaves a term out.
  const CompetingModel* model = nullptr;
};

/// Merges claim `from` into claim `to`: adds the probabilities, and averages the conditional probabilities with these
/// weights.
void mergeClaim(const Claim& from, Claim& to);

/// Returns all claims of the models, with probabilities that sum to one. Models without a fit are penalised by the
/// median loss of evidence of the fitted models.
[[nodiscard]] std::vector<Claim> claimsOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
