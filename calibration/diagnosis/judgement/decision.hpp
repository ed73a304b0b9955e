// From what is probable to the verdict.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/posterior.hpp"

namespace tubeplan::calibration {

/// Fills verdict, alternatives and what they agree on.
void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result);

}  // namespace tubeplan::calibration
