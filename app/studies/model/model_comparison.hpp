// Comparison of several models on the same measurements: shows how much each refinement of the model reduces the error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "app/studies/job_steps.hpp"
#include "app/studies/positioning/step_table.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Results of one model in a comparison.
struct ModelComparisonRow {
  std::string name;
  int fitted_numbers = 0;
  calibration::ErrorSize as_it_stands;  ///< error of the model before any fit, with the base stated in the file
  calibration::ErrorSize fitted;        ///< error with `identify` fitted, and with the base fitted if it is unknown
  calibration::ErrorSize heldout;
  double noise_floor = 0;  ///< rms error that the stated noise alone would cause [m]
  double chi2_per_dof = 0;
  /// P-value of chi-square for the stated noise; NaN if no noise is stated.
  double p_value = std::numeric_limits<double>::quiet_NaN();
  calibration::PlacedArm model;    ///< the fitted model; its arm has no rows if the fit failed
  std::optional<StepTable> steps;  ///< step table; std::nullopt if not requested
};

/// Compares a cell's model with the measurements. A model without free parameters is evaluated without a fit. Throws
/// JobStopped if a stop is requested.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const CellModel& cell,
                                                 const std::vector<calibration::Measurement>& measurements,
                                                 std::uint64_t seed, const WorkHooks& hooks = {});

/// Returns the comparison row of a model that is already fitted.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const calibration::Identification& fit);

/// Returns the fit of the cell's model to the measurements, for a comparison row. Its status is kNotRun if the cell has
/// no free parameters. Throws JobStopped if a stop is requested.
[[nodiscard]] calibration::Identification fitForLadder(const CellModel& cell,
                                                       const std::vector<calibration::Measurement>& measurements,
                                                       std::uint64_t seed, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
