// Posterior probabilities of competing models: classes of models with the same or indistinguishable causes, and the
// causes that are certain.
#pragma once

#include "calibration/diagnosis/judgement/claims.hpp"

namespace tubeplan::calibration {

/// Class of the models with the same causes, and their total probability; the models may differ in noise and
/// discrepancy. Indistinguishable causes are treated as the same.
struct ModelClass : Claim {
  Explanation explanation;  ///< explanation of the class's most probable model
};

/// Fraction of the best class's probability below which another class is neglected.
inline constexpr double kLeastLikely = 0.02;

struct Posterior {
  double nothing = 0;  ///< probability that nothing is missing
  /// Probability that the model lacks an unknown effect that depends on quantities stated by the measurements.
  double unknown = 0;
  /// Probability that the model lacks an unknown effect that depends on no quantity stated by the measurements.
  double scatter = 0;
  std::vector<ModelClass> classes;  ///< classes with a fitted model and at least one cause, most probable first
  std::vector<ModelClass> others;   ///< classes without a fitted model
  ModelClass certain;               ///< causes that are certain regardless of what else is missing; empty if none
  CompetingModel certain_model;     ///< model with the causes of `certain`
};

/// Computes the posterior from the complete list `work.models` and fits the model of the certain causes. Throws
/// WorkStopped on a request to stop.
[[nodiscard]] Posterior posteriorOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
