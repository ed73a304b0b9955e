// The search for the models that compete: from nothing missing, one cause more at a time, about the linearisation.
#pragma once

#include <limits>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Finds the models that compete about the linearisation, fills `work.models`. Unwinds where it was stopped.
void compareModels(DiagnosisWork& work);

/// One model more, as a quick look saw it.
struct Looked {
  std::vector<ModelTerm> terms;
  double log_share = 0, log_weight = -std::numeric_limits<double>::infinity();
};

/// Of a cause its best term beside what the seed has, of all or only some of its terms.
[[nodiscard]] Looked bestBeside(const DiagnosisWork& work, const CompetingModel& seed, int cause, bool of_all);

}  // namespace tubeplan::calibration
