// A competing model on the arm: what it frees beside the baseline's numbers, and what its terms became.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// A model under way: what is free beside the baseline's numbers.
struct PlacedModel {
  PlacedArm arm;
  std::vector<Unknown> sizes, shapes;
  std::vector<int> first_effect;    ///< index of each term's first effect in the arm
  std::vector<std::size_t> counts;  ///< sizes of each term
};

/// The baseline's arm with the model's effects. A step is where the readings' times say best.
[[nodiscard]] PlacedModel placeModel(const DiagnosisWork& work, const CompetingModel& model);

/// What a term of the fitted model became, effect by effect, into `fit.effects`; `sigma` of all sizes, in their typical
/// ones.
void describeTerm(const DiagnosisWork& work, const ModelTerm& term, const PlacedModel& placed, std::size_t index,
                  const Eigen::VectorXd& sigma, std::size_t first_size, Explanation& fit);

}  // namespace tubeplan::calibration
