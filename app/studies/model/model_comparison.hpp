// The error of one model after another on the same readings: the worth of each step of a model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "app/studies/job_steps.hpp"
#include "app/studies/positioning/step_table.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// One model on the ladder.
struct ModelComparisonRow {
  std::string name;
  int fitted_numbers = 0;
  calibration::ErrorSize as_it_stands;  ///< error with the base of the file
  calibration::ErrorSize fitted;        ///< error with `identify` fitted, and the base if it is unknown
  calibration::ErrorSize heldout;
  double noise_floor = 0;  ///< [m]
  double chi2_per_dof = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< p-value of chi-square, by the stated noise
  calibration::PlacedArm model;    ///< the fitted model; without rows if it could not be fitted
  std::optional<StepTable> steps;  ///< step table, if asked for
};

/// Judges a cell's model on readings; if it frees nothing, it is judged as it stands. Throws JobStopped.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const CellModel& cell,
                                                 const std::vector<calibration::Measurement>& readings,
                                                 std::uint64_t seed, const WorkHooks& hooks = {});

/// Returns the row of an already fitted model.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const calibration::Identification& fit);

/// Returns the fit for a row of the comparison, equal to the refit of `compare`. Not run if the cell frees nothing.
/// Throws JobStopped.
[[nodiscard]] calibration::Identification fitForLadder(const CellModel& cell,
                                                       const std::vector<calibration::Measurement>& readings,
                                                       std::uint64_t seed, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
