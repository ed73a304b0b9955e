// Diagnosis of the physical effect that a model lacks, with a verdict that states what the readings cannot decide.
//
// Every hypothesis has a prior and an evidence: nothing missing, a cause at its place, several causes, each with or
// without an unknown remainder, or the unknown alone. The evidence is the probability of the readings with the
// hypothesis's numbers integrated over their priors (Laplace's approximation about a separate fit). The posterior
// decides the verdict (Bayesian model class selection: Beck and Yuen 2004, J. Eng. Mech. 130:192).
#pragma once

#include <vector>

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/diagnosis_options.hpp"

namespace tubeplan::calibration {

[[nodiscard]] Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const DiagnosisOptions& options);

/// Competing models, each fitted with everything that is free, without a verdict.
struct CompetingExplanations {
  /// Models that the search fitted, including that nothing is missing; most probable first.
  std::vector<Explanation> found;
  /// Requested models in the order of the request; without effects if one cannot be fitted.
  std::vector<Explanation> asked;
};

/// Fits competing models and each requested one, given as a list of effects. If their values are not neutral, a second
/// fit starts at them and the more probable result is kept. Returns no models if the model cannot be fitted or on a
/// request to stop.
[[nodiscard]] CompetingExplanations competingExplanations(const PlacedArm& start,
                                                          const std::vector<Measurement>& readings,
                                                          const DiagnosisOptions& options,
                                                          const std::vector<std::vector<deflection::Effect>>& asked);

}  // namespace tubeplan::calibration
