// The numbers of tubes in which each number of the calibration tool's steps would enter, if a model steered the real
// arm.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// The arm that represents the real one.
struct RealArm {
  planner::Workcell cell;
  std::string name;       ///< description for people
  double unmodelled = 0;  ///< sigma of a coordinate of its error beyond its own model, independent in each posture [m]
};

/// A hole that the real arm reaches.
struct StepHole {
  int tube = -1;
  Eigen::VectorXd q;            ///< a posture of the branch that every model must use
  Eigen::Vector3d tip_error_W;  ///< error of the real arm beyond its model there [m]
};

struct StepHoles {
  std::vector<StepHole> holes;
  int out_of_reach = 0;  ///< number of holes drawn in addition, but beyond the real arm's reach
};

/// Draws open holes of the sheet at random until `count` are within the real arm's reach; fewer on a small sheet. Links
/// are not checked for collisions. The result is unusable once `stop` has returned true.
[[nodiscard]] StepHoles drawStepHoles(const RealArm& real, int count, std::uint64_t seed,
                                      const calibration::StopQuestion& stop = {});

struct StepTable {
  std::string reason;  ///< reason if there is none; else empty
  int holes = 0;
  std::vector<int> counts;  ///< holes in which 0, 1, ... steps enter
  int no_posture = 0;       ///< holes that the model does not reach: no step enters
  /// Centring error over the holes that it reaches [m].
  double median_error = std::numeric_limits<double>::quiet_NaN();
  double p95_error = std::numeric_limits<double>::quiet_NaN();  ///< [m]
};

/// Computes the table for a model that steers with its deflection compensated, with the tool axis of the real arm; the
/// tip's place is the real arm's. The result is unusable once `stop` has returned true.
[[nodiscard]] StepTable stepTableOf(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const RealArm& real,
                                    const StepHoles& holes, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
