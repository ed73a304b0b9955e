// Search for competing models by evidence that is linearised about the baseline. The search starts with nothing missing
// and adds one cause at a time.
#pragma once

#include <limits>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Finds the competing models by their evidence linearised about the baseline, and sets `work.models`. Throws
/// WorkStopped on a request to stop.
void compareModels(DiagnosisWork& work);

/// Candidate model: a model extended by one cause, with its estimated weight.
struct CandidateModel {
  std::vector<ModelTerm> terms;
  double log_share = 0, log_weight = -std::numeric_limits<double>::infinity();
};

/// Returns the terms of `seed` extended by the best term of `cause`, with the estimated weight. Tries all terms of the
/// cause if `of_all` is true, otherwise only some.
[[nodiscard]] CandidateModel bestExtension(const DiagnosisWork& work, const CompetingModel& seed, int cause,
                                           bool of_all);

}  // namespace tubeplan::calibration
