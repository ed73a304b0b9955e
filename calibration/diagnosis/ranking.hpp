// The effects of a diagnosis in order of their probability, and how large each could be and still hide.
#pragma once

#include "calibration/diagnosis/search.hpp"

namespace tubeplan::calibration {

/// Fills `ranking`. A model's weight is that of its information criterion, times the belief that its misfit leaves in
/// it; that nothing is missing is as likely beforehand as all effects of the catalogue together. An effect's
/// probability is that of all models it is part of; what is wanting to 1 is nothing missing, or something unknown.
void rank(const DiagnosisWork& work, const std::vector<Scored>& singles, const std::vector<Explanation>& fits,
          Diagnosis& result);

/// Fills `detectable`.
void listDetectable(const DiagnosisWork& work, double threshold, Diagnosis& result);

}  // namespace tubeplan::calibration
