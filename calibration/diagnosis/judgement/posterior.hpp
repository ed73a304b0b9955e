// Posterior probabilities of competing models: classes of models with the same causes, under whatever names, and the
// causes that are sure.
#pragma once

#include "calibration/diagnosis/judgement/claims.hpp"

namespace tubeplan::calibration {

/// Claim of all models with the same causes, whatever their noise and discrepancy. Causes that no reading could
/// distinguish count as the same.
struct ModelClass : Claim {
  Explanation explanation;  ///< explanation of the class's most probable model
};

/// Share of the best class's probability below which a class counts for little.
inline constexpr double kLeastLikely = 0.02;

struct Posterior {
  double nothing = 0;  ///< probability that nothing is missing
  double unknown = 0;  ///< probability that something is missing which follows the readings, without any named cause
  double scatter = 0;  ///< probability that something is missing which follows nothing that the readings state
  std::vector<ModelClass> classes;  ///< fitted classes with causes, most probable first
  std::vector<ModelClass> others;   ///< less probable classes that were not fitted
  ModelClass sure;                  ///< sure causes, whatever else is missing; empty: none
  CompetingModel sure_model;        ///< model of `sure`
};

/// Computes the posterior from the complete list `work.models` and fits the model of the sure causes. Throws
/// WorkStopped on a request to stop.
[[nodiscard]] Posterior posteriorOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
