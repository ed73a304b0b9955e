// Arm with the effects of a competing model, the unknowns in addition to the baseline's, and the description of the
// fitted terms.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Arm with a model's effects, and the unknowns in addition to the baseline's.
struct PlacedModel {
  PlacedArm arm;
  std::vector<Unknown> sizes, shapes;
  std::vector<int> first_effect;    ///< index in the arm of each term's first effect
  std::vector<std::size_t> counts;  ///< number of each term's unknowns in `sizes`
};

/// Returns the baseline's arm with the model's effects. A step is placed at the best time that the measurements can
/// resolve.
[[nodiscard]] PlacedModel placeModel(const DiagnosisWork& work, const CompetingModel& model);

/// Appends the effects of a fitted term to `fit.effects`. `sigma` contains the standard deviations of all
/// `placed.sizes`, in units of Unknown::typical.
void describeTerm(const DiagnosisWork& work, const ModelTerm& term, const PlacedModel& placed, std::size_t index,
                  const Eigen::VectorXd& sigma, std::size_t first_size, Explanation& fit);

}  // namespace tubeplan::calibration
