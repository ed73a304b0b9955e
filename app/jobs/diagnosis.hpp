// Diagnosis of the physical effect that a model lacks, with the next readings if that is undecided: from a cell and its
// readings to the figures.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/job_steps.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

struct DiagnosisRequest {
  int effects = 3;  ///< largest number in one explanation
  int next = 6;     ///< number of readings to propose
  std::uint64_t seed = 1;
};

struct DiagnosisOutcome {
  calibration::Diagnosis diagnosis;
  std::vector<calibration::ReadingCandidate> candidates;  ///< candidates for the readings to propose
  calibration::DiscriminatingMeasurements next;
  std::vector<calibration::EffectWarning> warnings;         ///< about effects that the cell has
  std::vector<calibration::ProposedMeasurement> run_sheet;  ///< the proposed readings; empty: none is proposed
  nlohmann::json figures;                                   ///< JSON of `tubeplan diagnose --json`
};

/// Returns the diagnosis alone, without further readings and warnings; not run if the readings determine nothing.
[[nodiscard]] calibration::Diagnosis diagnoseReadings(const Cell& cell,
                                                      const std::vector<calibration::Measurement>& readings,
                                                      const DiagnosisRequest& request, const WorkHooks& hooks = {});

/// Diagnoses the model. Throws InputError for readings that determine nothing, JobStopped.
[[nodiscard]] DiagnosisOutcome diagnoseModel(const CellReadings& input, const DiagnosisRequest& request,
                                             const WorkHooks& hooks = {});

}  // namespace tubeplan::app
