// Fit of an arm for a file that cannot state all of the cell's model. Numbers that were fitted together with an effect
// or a compliance are wrong for an arm without it, so they are fitted again to the measurements.
#pragma once

#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/job_steps.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Parts of a model that a file of an arm can state.
enum class ArmFileContent { kRigid, kCompliant };

/// Errors [m] at the fitted measurements, each with the base fitted, where it was calibrated or is unknown.
struct ExportFit {
  deflection::Arm arm;                ///< arm that the file states, with its numbers fitted again
  std::vector<std::string> left_out;  ///< parts of the model that the file cannot state
  int measurements = 0;
  calibration::ErrorSize of_model;   ///< error of the cell's whole model
  calibration::ErrorSize as_fitted;  ///< error of the part that the file can state, with the numbers of the cell
  calibration::ErrorSize refitted;   ///< error of `arm`
  calibration::ErrorSize heldout;    ///< error of `arm` at measurements held out of its fit
};

/// Returns true if a file of this content states the arm's whole model.
[[nodiscard]] bool statesAll(const deflection::Arm& arm, ArmFileContent content);

/// Fits the geometric numbers of the cell's `identify`, or the tip and the geometry if it names none, without effects
/// that depend on the posture and, for kRigid, without compliances. Throws InputError for a mistake in the measurements
/// and for a fit that does not end.
[[nodiscard]] ExportFit fitForExport(const CellMeasurements& input, ArmFileContent content,
                                     const WorkHooks& hooks = {});

}  // namespace tubeplan::app
