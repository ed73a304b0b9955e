// A model with causes added: its numbers for further fits, and how it does on readings kept out.
#pragma once

#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::calibration {

/// What all fits of one diagnosis share.
struct DiagnosisBasis {
  std::vector<Measurement> readings;  ///< those in use
  PlacedArm fitted;                   ///< the baseline at its optimum
  std::vector<Unknown> unknowns;      ///< of the baseline, 0 at its optimum
  ReadingWeights weights;             ///< by the stated noise
  WhitenedResidual residual;          ///< at the optimum, with the Jacobian by `unknowns`
  StopQuestion stop = {};             ///< asked within fits, which unwind where the answer is yes
};

/// The variables of a baseline's unknowns, moved so that 0 is its optimum.
[[nodiscard]] DiagnosisBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings,
                                     const StopQuestion& stop = {});

/// A state and the unknowns of a model with causes, 0 there.
struct ExplanationModel {
  PlacedArm placed;
  std::vector<Unknown> unknowns;
};
[[nodiscard]] ExplanationModel modelOf(const DiagnosisBasis& basis, const Explanation& explanation);

/// Errors on readings kept out, fold by fold.
[[nodiscard]] ErrorSize judgeOnFolds(const DiagnosisBasis& basis, const ExplanationModel& model,
                                     const std::vector<int>& folds, double model_error);

}  // namespace tubeplan::calibration
