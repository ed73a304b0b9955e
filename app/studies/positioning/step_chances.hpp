// Probabilities that 0, 1, ... steps of the calibration tool enter a hole, under all uncertainties: joint readings,
// base, arm parameters and model error.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/forecast/tip_error.hpp"
#include "planner/reach/scoring.hpp"

namespace tubeplan::app {

struct StepChances {
  std::string reason;                     ///< reason why there are no probabilities; empty on success
  std::optional<ModelError> model_error;  ///< model error used; std::nullopt if not considered
  bool base_is_exact = false;             ///< true if the base is stated as known, without uncertainty
  /// True if the uncertainty of the arm parameters is unknown and not considered.
  bool numbers_are_exact = false;
  /// Probabilities of 0, 1, ... steps for each posture; they add up to 1.
  std::vector<std::vector<double>> by_posture;
};

/// Input of stepChances(): the placed model, its postures at the holes, and the predicted centring in each posture.
struct StepQuestion {
  const CellModel& cell;           ///< the cell as read, with its statements on base, parameters and model error
  const planner::Workcell& model;  ///< the workcell, with the base used for planning
  /// Calibration that determined the base of `model`; null if the cell states the base.
  const calibration::BaseCalibration* placed_by;
  const std::vector<Eigen::VectorXd>& postures;
  const std::vector<planner::Centring>& predicted;  ///< centring as the model predicts it, one for each posture
};

/// Returns the probabilities of the steps in each posture; none if the base pose is only nominal.
[[nodiscard]] StepChances stepChances(const StepQuestion& question);

/// Returns the joint uncertainty of base and arm: from the calibration that determined the model's base or, if
/// `placed_by` is null, as stated in the cell.
[[nodiscard]] calibration::JointUncertainty jointUncertaintyOf(const CellModel& cell, const planner::Workcell& model,
                                                               const calibration::BaseCalibration* placed_by);

/// Returns the most probable number of steps; the smallest if several are equally probable.
[[nodiscard]] int likeliestSteps(const std::vector<double>& chances);

/// Returns the expected number of holes in which 0, 1, ... steps enter.
[[nodiscard]] std::vector<double> expectedCounts(const StepChances& chances);

/// Returns the model error for a calibrated base: estimated from touches that do not fit, or else the known model error
/// of the cell.
[[nodiscard]] std::optional<ModelError> modelErrorFor(const CellModel& cell, const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
