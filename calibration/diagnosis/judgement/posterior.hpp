// From competing models to what is probable: classes of models with the same causes, under whatever names, and the
// causes that are sure.
#pragma once

#include "calibration/diagnosis/judgement/claims.hpp"

namespace tubeplan::calibration {

/// What models with the same causes claim together, whatever noise and discrepancy they have beside; causes that no
/// reading could tell apart count as the same.
struct ModelClass : Claim {
  Explanation explanation;  ///< of its most probable model
};

inline constexpr double kLeastLikely =
    0.02;  ///< of the best class's probability, below which a class counts for little

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
