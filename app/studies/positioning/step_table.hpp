// Step table: the number of holes in which 0, 1, ... steps of the calibration tool would enter if a model steered the
// real arm.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Workcell and unmodelled error that represent the real arm.
struct RealArm {
  planner::Workcell cell;
  std::string name;  ///< description for the user
  /// Standard deviation of each coordinate of the unmodelled tip error [m], independent in each posture.
  double unmodelled = 0;
};

/// A hole that the real arm reaches.
struct StepHole {
  int tube = -1;
  Eigen::VectorXd q;            ///< a posture in the branch that every model must use
  Eigen::Vector3d tip_error_W;  ///< unmodelled tip error of the real arm in this posture [m]
};

struct StepHoles {
  std::vector<StepHole> holes;
  int out_of_reach = 0;  ///< number of additional holes drawn that the real arm does not reach
};

/// Draws open holes of the sheet at random until the real arm reaches `count` of them; fewer if the sheet has too few.
/// Links are not checked for collisions. The result is invalid if `stop` has returned true.
[[nodiscard]] StepHoles drawStepHoles(const RealArm& real, int count, std::uint64_t seed,
                                      const calibration::StopQuestion& stop = {});

struct StepTable {
  std::string reason;  ///< reason why there is no table; empty on success
  int holes = 0;
  std::vector<int> counts;  ///< number of holes in which 0, 1, ... steps enter
  int no_posture = 0;       ///< number of holes for which the model finds no posture; counted as 0 steps
  /// Median of the centring error over the holes for which the model finds a posture [m]; NaN if none.
  double median_error = std::numeric_limits<double>::quiet_NaN();
  /// 95th percentile of the centring error [m]; NaN if none.
  double p95_error = std::numeric_limits<double>::quiet_NaN();
};

/// Computes the step table of a model that steers the real arm with compensated deflection. The model uses the tool
/// axis of the real arm. The tip position is computed with the real arm. The result is invalid if `stop` has returned
/// true.
[[nodiscard]] StepTable stepTableOf(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const RealArm& real,
                                    const StepHoles& holes, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
