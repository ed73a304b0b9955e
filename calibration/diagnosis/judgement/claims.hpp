// What competing models claim is missing, with probabilities that are one together.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// What one model says, or what it says if one of its terms is but a likeness of something unknown.
struct Claim {
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;         ///< that the noise is larger than stated, and nothing else remains
  const CompetingModel* model = nullptr;  ///< none of a likeness; of several the most probable
};

/// Counts one claim to another.
void mixIn(const Claim& one, Claim& to);

/// All that the models claim, its probabilities one together. Those that were not fitted would have lost as others did.
[[nodiscard]] std::vector<Claim> claimsOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
