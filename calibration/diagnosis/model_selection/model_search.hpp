// Search for competing models: from nothing missing, with one more cause at a time, about the linearisation.
#pragma once

#include <limits>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Finds the models that compete about the linearisation and sets `work.models`. Throws WorkStopped on a request to
/// stop.
void compareModels(DiagnosisWork& work);

/// Model with one more cause, with its estimated weight.
struct Looked {
  std::vector<ModelTerm> terms;
  double log_share = 0, log_weight = -std::numeric_limits<double>::infinity();
};

/// Returns the best term of a cause beside those of the seed, out of all its terms or only some of them.
[[nodiscard]] Looked bestBeside(const DiagnosisWork& work, const CompetingModel& seed, int cause, bool of_all);

}  // namespace tubeplan::calibration
