// Diagnosis of the physical effect that a model lacks, and proposal of further measurements if the diagnosis is
// undecided.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/job_steps.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/effect_warnings.hpp"

namespace tubeplan::app {

struct DiagnosisRequest {
  int effects = 3;  ///< largest number of effects in one explanation
  int next = 6;     ///< number of measurements to propose
  std::uint64_t seed = 1;
};

struct DiagnosisOutcome {
  calibration::Diagnosis diagnosis;
  std::vector<calibration::MeasurementCandidate>
      candidates;  ///< candidates from which the proposed measurements are chosen
  calibration::DiscriminatingMeasurements next;
  std::vector<calibration::EffectWarning> warnings;  ///< warnings about effects that the cell's model already contains
  std::vector<calibration::ProposedMeasurement> run_sheet;  ///< proposed measurements; empty if none are proposed
  nlohmann::json figures;                                   ///< output of `tubeplan diagnose --json`
};

/// Returns the diagnosis alone, without proposed measurements and warnings. Its verdict is kNotRun if the measurements
/// determine no parameter.
[[nodiscard]] calibration::Diagnosis diagnoseMeasurements(const Cell& cell,
                                                          const std::vector<calibration::Measurement>& measurements,
                                                          const DiagnosisRequest& request, const WorkHooks& hooks = {});

/// Diagnoses which effects the model lacks. Throws InputError for measurements that determine no parameter, and
/// JobStopped if a stop is requested.
[[nodiscard]] DiagnosisOutcome diagnoseModel(const CellMeasurements& input, const DiagnosisRequest& request,
                                             const WorkHooks& hooks = {});

}  // namespace tubeplan::app
