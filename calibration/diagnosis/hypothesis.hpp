// A model with effects added, fitted with everything that is free, and how well it does.
#pragma once

#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::calibration {

/// What all fits of one diagnosis share. Weights are those of the baseline, so that chi-squares compare.
struct DiagnosisBasis {
  std::vector<Measurement> readings;  ///< those in use
  PlacedArm fitted;                   ///< the baseline at its optimum
  std::vector<Unknown> unknowns;      ///< kept by the baseline, 0 at its optimum
  ReadingWeights weights;
  WhitenedResidual residual;  ///< at the optimum, with the Jacobian by `unknowns`
  StopQuestion stop = {};     ///< asked within fits, which unwind where the answer is yes
};

/// The variables of a baseline's kept unknowns, moved so that 0 is its optimum.
[[nodiscard]] DiagnosisBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings);

/// Fits the model with these variants of the catalogue, from their scores.
[[nodiscard]] Explanation fitExplanation(const DiagnosisBasis& basis, const Catalogue& catalogue,
                                         const ScoreSpace& space, const std::vector<int>& variants);

/// Unknowns and state of a fitted explanation, for judging it on readings kept out.
struct ExplanationModel {
  PlacedArm placed;
  std::vector<Unknown> unknowns;
};
[[nodiscard]] ExplanationModel modelOf(const DiagnosisBasis& basis, const Explanation& explanation);

/// Errors on readings kept out, fold by fold.
[[nodiscard]] ErrorSize judgeOnFolds(const DiagnosisBasis& basis, const ExplanationModel& model,
                                     const std::vector<int>& folds);

}  // namespace tubeplan::calibration
