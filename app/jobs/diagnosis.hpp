// Diagnosis of the physical effect that a model lacks, and proposal of further readings if the diagnosis is undecided.
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
  int effects = 3;  ///< largest number of effects in one explanation
  int next = 6;     ///< number of readings to propose
  std::uint64_t seed = 1;
};

struct DiagnosisOutcome {
  calibration::Diagnosis diagnosis;
  std::vector<calibration::ReadingCandidate> candidates;  ///< candidates from which the proposed readings are chosen
  calibration::DiscriminatingMeasurements next;
  std::vector<calibration::EffectWarning> warnings;  ///< warnings about effects that the cell's model already contains
  std::vector<calibration::ProposedMeasurement> run_sheet;  ///< proposed readings; empty if none are proposed
  nlohmann::json figures;                                   ///< output of `tubeplan diagnose --json`
};

/// Returns the diagnosis alone, without proposed readings and warnings. Its verdict is kNotRun if the readings
/// determine no parameter.
[[nodiscard]] calibration::Diagnosis diagnoseReadings(const Cell& cell,
                                                      const std::vector<calibration::Measurement>& readings,
                                                      const DiagnosisRequest& request, const WorkHooks& hooks = {});

/// Diagnoses which effects the model lacks. Throws InputError for readings that determine no parameter, and JobStopped
/// if a stop is requested.
[[nodiscard]] DiagnosisOutcome diagnoseModel(const CellReadings& input, const DiagnosisRequest& request,
                                             const WorkHooks& hooks = {});

}  // namespace tubeplan::app
