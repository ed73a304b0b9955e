// Which physical effect a model lacks, and what to read next where that is left open: from a cell and its readings to
// the figures.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "app/studies/job_steps.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/discriminating_measurements.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

struct DiagnosisRequest {
  int effects = 3;  ///< the most in one explanation
  int next = 6;     ///< readings to propose
  std::uint64_t seed = 1;
};

struct DiagnosisOutcome {
  calibration::Diagnosis diagnosis;
  std::vector<calibration::ReadingCandidate> candidates;  ///< of the readings to propose
  calibration::DiscriminatingMeasurements next;
  std::vector<calibration::EffectWarning> warnings;         ///< of the effects that the cell has
  std::vector<calibration::ProposedMeasurement> run_sheet;  ///< the proposed readings; empty: none is proposed
  nlohmann::json figures;                                   ///< as `tubeplan diagnose --json` writes them
};

/// The diagnosis alone, without further readings and warnings; not run where the readings determine nothing.
[[nodiscard]] calibration::Diagnosis diagnoseReadings(const Cell& cell,
                                                      const std::vector<calibration::Measurement>& readings,
                                                      const DiagnosisRequest& request, const WorkHooks& hooks = {});

/// Throws InputError for readings that determine nothing, JobStopped.
[[nodiscard]] DiagnosisOutcome diagnoseModel(const CellReadings& input, const DiagnosisRequest& request,
                                             const WorkHooks& hooks = {});

}  // namespace tubeplan::app
