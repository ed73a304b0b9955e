// Simulated touches of holes with a true arm: the choice of holes, the readings, and the resulting base.
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

/// Returns holes spread over the sheet that the arm reaches without collision, each with a posture, as candidates for
/// touching.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, int count);

/// Returns the candidates of given tubes.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell,
                                                                  const std::vector<int>& tubes);

/// The `count` candidates that place the base best, given the doubt of the arm, named T1, T2, ... Those that could be
/// out of reach from the true base are taken only if there are too few others.
struct BestTouches {
  std::vector<calibration::TouchPlan> plans;
  std::string reason;  ///< reason if there are none; else empty
  /// Predicted sigma of a tip coordinate over the work [m].
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the best touches for the tip at the candidates.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates, int count,
                                      const calibration::DoubtBeside& doubt);

/// Returns the best touches for the tip in the postures of the work.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates,
                                      const std::vector<Eigen::VectorXd>& work, int count,
                                      const calibration::DoubtBeside& doubt);

/// Returns the best of candidates that can surely be touched.
[[nodiscard]] BestTouches bestTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const std::vector<calibration::TouchPlan>& touchable,
                                      const std::vector<Eigen::VectorXd>& work,
                                      const calibration::TouchChoiceOptions& options);

/// Returns the index in the sheet of the tube whose hole a candidate names.
[[nodiscard]] int tubeOf(const calibration::TouchPlan& candidate, const tubesheets::Sheet& sheet);

/// The base by the flexible model and, for comparison, by the rigid one, whose numbers are taken as exact.
struct BothCalibrations {
  calibration::BaseCalibration flexible, rigid;
};
[[nodiscard]] BothCalibrations calibrateBoth(const planner::Workcell& placed, const CellModel& cell,
                                             const std::vector<calibration::Measurement>& touches);

/// Calibrates with both arms given, for many calibrations of a model; errors of touches are not searched for.
[[nodiscard]] BothCalibrations calibrateBoth(const deflection::Arm& flexible, const deflection::Arm& rigid,
                                             const calibration::DoubtBeside& doubt, const Eigen::Isometry3d& X_WB_start,
                                             const tubesheets::Sheet& sheet,
                                             const std::vector<calibration::Measurement>& touches);

/// Returns the cell with its calibrated base, and its arm with the numbers fitted to the touches.
[[nodiscard]] planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
