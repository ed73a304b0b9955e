// Which physical effect a model lacks: named where the readings show it, and said so where they cannot.
//
// One idea: every hypothesis (nothing missing; a cause at its place; several; each with an unknown remainder or
// without; the unknown alone) has a prior and an evidence, the probability of the readings with its numbers integrated
// over their priors (Laplace's approximation about a fit of its own). The posterior decides the verdict (Bayesian model
// class selection: Beck and Yuen 2004, J. Eng. Mech. 130:192).
#pragma once

#include <vector>

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/diagnosis_options.hpp"

namespace tubeplan::calibration {

[[nodiscard]] Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings,
                                 const DiagnosisOptions& options);

/// Models that compete, each fitted with everything that is free; without a verdict.
struct CompetingExplanations {
  std::vector<Explanation> found;  ///< those that the search fitted, nothing missing among them; most probable first
  std::vector<Explanation> asked;  ///< as asked for, in that order; without effects where one cannot be fitted
};

/// Each model asked for is a list of effects; where their values are not neutral the fit is begun at these too, and the
/// more probable end is taken. Nothing is found where the model cannot be fitted, or where it was asked to stop.
[[nodiscard]] CompetingExplanations competingExplanations(const PlacedArm& start,
                                                          const std::vector<Measurement>& readings,
                                                          const DiagnosisOptions& options,
                                                          const std::vector<std::vector<deflection::Effect>>& asked);

}  // namespace tubeplan::calibration
