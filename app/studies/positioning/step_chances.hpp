// With what probability how many steps of the calibration tool go in, under all that is uncertain: the joints'
// readings, where the base stands, and what the arm does beyond its model.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/forecast/tip_error.hpp"
#include "planner/reach/scoring.hpp"

namespace tubeplan::app {

struct StepChances {
  std::string reason;                           ///< why there are none; empty where there are some
  std::optional<ModelError> model_error;        ///< as counted; none: left out
  bool base_is_exact = false;                   ///< somebody says that the base is known, and not how well
  bool numbers_are_exact = false;               ///< nothing is known of how well the arm's numbers are
  std::vector<std::vector<double>> by_posture;  ///< of 0, 1, ... steps; each adds up to 1
};

/// Where the arm goes by its model, and how the tool stands there by it.
struct StepQuestion {
  const CellModel& cell;                          ///< as read: what it says of base, numbers and model error
  const planner::Workcell& model;                 ///< placed
  const calibration::BaseCalibration* placed_by;  ///< that placed it; null: it stands as the cell has it
  const std::vector<Eigen::VectorXd>& postures;
  const std::vector<planner::Centring>& predicted;  ///< by the model itself, one for each posture
};

/// None for a base that nobody placed.
[[nodiscard]] StepChances stepChances(const StepQuestion& question);

/// The likeliest number of steps; of two as likely, the lower.
[[nodiscard]] int likeliestSteps(const std::vector<double>& chances);

/// How many holes take 0, 1, ... steps on the average.
[[nodiscard]] std::vector<double> expectedCounts(const StepChances& chances);

/// Returns the model's own error beside a calibrated base: that of touches which do not fit, else the known one.
[[nodiscard]] std::optional<ModelError> modelErrorBeside(const CellModel& cell,
                                                         const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
