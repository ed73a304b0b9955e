// Verdict from posterior probabilities.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/posterior.hpp"

namespace tubeplan::calibration {

/// Sets the verdict, the alternatives and the causes on which the alternatives agree.
void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result);

}  // namespace tubeplan::calibration
