// Diagnosis of the physical effects that a model lacks. If the measurements cannot decide between explanations, the
// verdict says so.
//
// Every hypothesis has a prior and an evidence. The hypotheses are: nothing missing; one cause at its place, or several
// causes, each with or without an unexplained discrepancy; an unexplained discrepancy alone. The evidence is the
// probability of the measurements, with the hypothesis's parameters integrated over their priors (Laplace's
// approximation about a separate fit). The posterior decides the verdict (Bayesian model class selection: Beck and Yuen
// 2004, J. Eng. Mech. 130:192).
#pragma once

#include <vector>

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/diagnosis_options.hpp"

namespace tubeplan::calibration {

[[nodiscard]] Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                 const DiagnosisOptions& options);

/// Competing models, each fitted together with all free parameters, without a verdict.
struct CompetingExplanations {
  /// Models that the search fitted, including the model with nothing missing; most probable first.
  std::vector<Explanation> found;
  /// Requested models in the order of the request; a model that cannot be fitted has no effects.
  std::vector<Explanation> requested;
};

/// Fits the models that the search finds, and the requested models `requested`, each given as a list of effects. If the
/// requested effects have values other than neutral, a second fit starts from these values, and the more probable of
/// the two results is kept. Returns no models if the baseline cannot be fitted or the work was stopped on request.
[[nodiscard]] CompetingExplanations competingExplanations(
    const PlacedArm& start, const std::vector<Measurement>& measurements, const DiagnosisOptions& options,
    const std::vector<std::vector<deflection::Effect>>& requested);

}  // namespace tubeplan::calibration
