// Probabilities of the number of the calibration tool's steps that enter, under all uncertainty: of the joints'
// readings, of the base, and of the arm beyond its model.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/forecast/tip_error.hpp"
#include "planner/reach/scoring.hpp"

namespace tubeplan::app {

struct StepChances {
  std::string reason;                     ///< reason if there are none; else empty
  std::optional<ModelError> model_error;  ///< error used; nothing: left out
  bool base_is_exact = false;             ///< true: the base is stated as known, without an uncertainty
  bool numbers_are_exact = false;         ///< true: the uncertainty of the arm's numbers is unknown
  /// Probabilities of 0, 1, ... steps at each posture; each list adds up to 1.
  std::vector<std::vector<double>> by_posture;
};

/// Input of stepChances(): the goals of the arm by its model, and the tool's predicted poses.
struct StepQuestion {
  const CellModel& cell;           ///< the cell that was read: its statements on base, numbers and model error
  const planner::Workcell& model;  ///< the placed workcell
  const calibration::BaseCalibration* placed_by;  ///< calibration that placed it; null: the base is that of the cell
  const std::vector<Eigen::VectorXd>& postures;
  const std::vector<planner::Centring>& predicted;  ///< centring by the model itself, one for each posture
};

/// Returns the probabilities; none for a base that was never placed.
[[nodiscard]] StepChances stepChances(const StepQuestion& question);

/// Returns the likeliest number of steps; the lower of two equally likely ones.
[[nodiscard]] int likeliestSteps(const std::vector<double>& chances);

/// Returns the expected numbers of holes that take 0, 1, ... steps.
[[nodiscard]] std::vector<double> expectedCounts(const StepChances& chances);

/// Returns the model's own error for a calibrated base: that estimated from touches which do not fit, else the known
/// one.
[[nodiscard]] std::optional<ModelError> modelErrorBeside(const CellModel& cell,
                                                         const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
