// Simulated calibration of a base: choice of holes, touches of the holes by the true arm, and fit of the base to the
// touches.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/design/touch_choice.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Spreads `count` holes over the sheet and returns those that the arm can touch without collision, each with a
/// posture.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, int count);

/// Returns candidates for touching among the given tubes: those that the arm reaches without collision.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell,
                                                                  const std::vector<int>& tubes);

/// Touches, with ids T1, T2, ..., that minimize the tip's uncertainty, given the uncertainty of the arm. Candidates
/// that might be out of reach from the true base are used only if there are too few others.
struct BestTouches {
  std::vector<calibration::TouchPlan> plans;
  std::string reason;  ///< reason why there are no touches; empty on success
  /// Predicted standard deviation of a tip coordinate, averaged over the work postures [m].
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the `count` touches that minimize the tip's uncertainty in the postures of the candidates themselves.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates, int count,
                                      const calibration::AdditionalUncertainty& additional);

/// Returns the `count` touches that minimize the tip's uncertainty in the postures `work`.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates,
                                      const std::vector<Eigen::VectorXd>& work, int count,
                                      const calibration::AdditionalUncertainty& additional);

/// Returns the touches that minimize the tip's uncertainty in the postures `work`; `touchable` are candidates that the
/// arm is known to reach.
[[nodiscard]] BestTouches bestTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const std::vector<calibration::TouchPlan>& touchable,
                                      const std::vector<Eigen::VectorXd>& work,
                                      const calibration::TouchChoiceOptions& options);

/// Returns the sheet's index of the tube whose hole the candidate names.
[[nodiscard]] int tubeOf(const calibration::TouchPlan& candidate, const tubesheets::Sheet& sheet);

/// Base calibrated with the flexible model and, for comparison, with a rigid model whose parameters are assumed to be
/// exact.
struct BothCalibrations {
  calibration::BaseCalibration flexible, rigid;
};
[[nodiscard]] BothCalibrations calibrateBoth(const planner::Workcell& placed, const CellModel& cell,
                                             const std::vector<calibration::Measurement>& touches);

/// Calibrates the base with each of the given arms. If the same model is calibrated many times, this is faster than the
/// function above. However, it does not search for a wrong joint reading if the touches do not fit.
[[nodiscard]] BothCalibrations calibrateBoth(const deflection::Arm& flexible, const deflection::Arm& rigid,
                                             const calibration::AdditionalUncertainty& additional,
                                             const Eigen::Isometry3d& X_WB_start, const tubesheets::Sheet& sheet,
                                             const std::vector<calibration::Measurement>& touches);

/// Returns the workcell with its calibrated base and with the arm parameters fitted to the touches.
[[nodiscard]] planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
