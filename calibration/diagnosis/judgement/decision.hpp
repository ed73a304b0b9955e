// Verdict from posterior probabilities.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/posterior.hpp"

namespace tubeplan::calibration {

/// Sets the verdict, the alternatives and the causes that they agree on.
void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result);

}  // namespace tubeplan::calibration
