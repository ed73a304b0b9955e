// From competing models to what is probable: classes of models with the same causes, under whatever names, and the
// causes that are sure.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Models with the same causes, whatever noise and discrepancy they have beside; causes that no reading could tell
/// apart count as the same.
struct ModelClass {
  Explanation explanation;  ///< of its most probable model
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;         ///< that the noise is larger than stated, and nothing else remains
  const CompetingModel* model = nullptr;  ///< the most probable
};

inline constexpr double kLeastLikely =
    0.02;  ///< of the best class's probability, below which a class counts for little

/// Counts one class to another.
void mixIn(const ModelClass& one, ModelClass& to);

struct Posterior {
  double nothing = 0;               ///< that nothing is missing
  double unknown = 0;               ///< that something is that follows the readings, and no cause is part of it
  double scatter = 0;               ///< that something is, and follows nothing that the readings state
  std::vector<ModelClass> classes;  ///< with causes, most probable first; those that were fitted
  std::vector<ModelClass> others;   ///< the less probable ones that were not
  ModelClass sure;                  ///< the causes that are sure, whatever there is beside; empty where none is
  CompetingModel sure_model;        ///< of `sure`
};

/// `work.models` must be found. Fits the model of the causes that are sure. Unwinds where it was stopped.
[[nodiscard]] Posterior posteriorOf(const DiagnosisWork& work);

}  // namespace tubeplan::calibration
