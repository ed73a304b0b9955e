// Model with added causes: its unknowns for further fits, and its errors on held-out measurements.
#pragma once

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// Fitted state and unknowns of a model with causes; the unknowns are zero at this state.
struct ExplanationModel {
  PlacedArm placed;
  std::vector<Unknown> unknowns;
};

/// Returns the index, among the effects of the fitted arm, of the first effect that the explanation adds.
[[nodiscard]] int firstAdded(const Explanation& explanation);

[[nodiscard]] ExplanationModel modelOf(const FittedBasis& basis, const Explanation& explanation);

/// Returns the errors in cross-validation: the measurements of each fold are predicted by a fit to the other folds.
[[nodiscard]] ErrorSize judgeOnFolds(const FittedBasis& basis, const ExplanationModel& model,
                                     const std::vector<int>& folds, double model_error);

}  // namespace tubeplan::calibration
