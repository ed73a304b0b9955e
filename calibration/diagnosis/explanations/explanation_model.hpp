// A model with causes added: its numbers for further fits, and how it does on readings kept out.
#pragma once

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// A state and the unknowns of a model with causes, 0 there.
struct ExplanationModel {
  PlacedArm placed;
  std::vector<Unknown> unknowns;
};

/// Returns the index in the fitted arm of the first effect that the explanation adds.
[[nodiscard]] int firstAdded(const Explanation& explanation);

[[nodiscard]] ExplanationModel modelOf(const FittedBasis& basis, const Explanation& explanation);

/// Errors on readings kept out, fold by fold.
[[nodiscard]] ErrorSize judgeOnFolds(const FittedBasis& basis, const ExplanationModel& model,
                                     const std::vector<int>& folds, double model_error);

}  // namespace tubeplan::calibration
