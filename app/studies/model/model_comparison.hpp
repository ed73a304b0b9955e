// The error of one model after another on the same readings: what each step of a model is worth.
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
  calibration::ErrorSize as_it_stands;  ///< with the file's own base
  calibration::ErrorSize fitted;        ///< with `identify`, and the base where it is not known, fitted
  calibration::ErrorSize heldout;
  double noise_floor = 0;  ///< m
  double chi2_per_dof = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();  ///< of chi-square, against the stated noise
  calibration::PlacedArm model;                               ///< as fitted; no rows where it could not be
  std::optional<StepTable> steps;                             ///< where they were asked for
};

/// A cell's model on readings; where it frees nothing it is judged as it stands. Throws JobStopped.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const CellModel& cell,
                                                 const std::vector<calibration::Measurement>& readings,
                                                 std::uint64_t seed, const WorkHooks& hooks = {});

/// The same of a model that a fit has left.
[[nodiscard]] ModelComparisonRow comparisonRowOf(const std::string& name, const calibration::Identification& fit);

/// The fit that a row of the comparison is of: as `compare` refits. Not run where the cell frees nothing. Throws
/// JobStopped.
[[nodiscard]] calibration::Identification fitForLadder(const CellModel& cell,
                                                       const std::vector<calibration::Measurement>& readings,
                                                       std::uint64_t seed, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
