// Touching holes with a true arm that is only simulated: which holes, what it reads, and the base that follows.
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

/// Holes spread over the sheet that the arm reaches without collision, each with a posture: candidates for touching.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, int count);

/// The same of given tubes.
[[nodiscard]] std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell,
                                                                  const std::vector<int>& tubes);

/// The candidates that place the base best beside the doubt of the arm, `count` of them, named T1, T2, ... Those that
/// could be out of reach from where the base really stands are taken only where there are too few others.
struct BestTouches {
  std::vector<calibration::TouchPlan> plans;
  std::string reason;                                            ///< why there are none; empty where there are
  double mean_sigma = std::numeric_limits<double>::quiet_NaN();  ///< as calibration::TouchChoice has it
};

/// Best for the tip at the candidates.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates, int count,
                                      const calibration::DoubtBeside& doubt);

/// Best for the tip in the postures of the work.
[[nodiscard]] BestTouches bestTouches(const planner::Workcell& cell,
                                      const std::vector<calibration::TouchPlan>& candidates,
                                      const std::vector<Eigen::VectorXd>& work, int count,
                                      const calibration::DoubtBeside& doubt);

/// The best of candidates that can surely be touched.
[[nodiscard]] BestTouches bestTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                      const std::vector<calibration::TouchPlan>& touchable,
                                      const std::vector<Eigen::VectorXd>& work,
                                      const calibration::TouchChoiceOptions& options);

/// The tube whose hole a candidate names, by its index in the sheet.
[[nodiscard]] int tubeOf(const calibration::TouchPlan& candidate, const tubesheets::Sheet& sheet);

/// The base by the flexible model and, for comparison, by the rigid one, whose numbers are taken as exact.
struct BothCalibrations {
  calibration::BaseCalibration flexible, rigid;
};
[[nodiscard]] BothCalibrations calibrateBoth(const planner::Workcell& placed, const CellModel& cell,
                                             const std::vector<calibration::Measurement>& touches);

/// Calibrates with both arms at hand, for many calibrations of a model: nothing is said of touches that do not fit.
[[nodiscard]] BothCalibrations calibrateBoth(const deflection::Arm& flexible, const deflection::Arm& rigid,
                                             const calibration::DoubtBeside& doubt, const Eigen::Isometry3d& X_WB_start,
                                             const tubesheets::Sheet& sheet,
                                             const std::vector<calibration::Measurement>& touches);

/// Returns the cell with its base as calibrated, and its arm as the touches have it.
[[nodiscard]] planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base);

}  // namespace tubeplan::app
