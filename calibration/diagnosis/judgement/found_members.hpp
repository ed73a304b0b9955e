// Explanation by an effect that acts at every joint, limited to the joints found: joints whose fitted sizes are within
// the noise are omitted.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Returns the model's explanation without doubtful members of a collective cause, refitted. As many of them are left
/// out as the evidence allows: the measurements alone, before the prior of the causes, must be nearly as probable by
/// the smaller model. The model must have a fit.
[[nodiscard]] Explanation explanationByFoundMembers(const DiagnosisWork& work, const CompetingModel& model);

}  // namespace tubeplan::calibration
