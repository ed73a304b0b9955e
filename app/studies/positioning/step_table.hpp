// In how many tubes how many steps of the calibration tool would go in, were a model to steer the real arm.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// The arm that stands for the real one.
struct RealArm {
  planner::Workcell cell;
  std::string name;       ///< what it is, for people
  double unmodelled = 0;  ///< m, sigma of a coordinate of what it does beyond its own model, another in each posture
};

/// A hole that the real arm reaches.
struct StepHole {
  int tube = -1;
  Eigen::VectorXd q;            ///< a posture of the branch that every model is to use
  Eigen::Vector3d tip_error_W;  ///< m, of the real arm beyond its model there
};

struct StepHoles {
  std::vector<StepHole> holes;
  int out_of_reach = 0;  ///< drawn beside them, but past the real arm's reach
};

/// Open holes of the sheet in random order until `count` are within the real arm's reach; fewer on a small sheet. Links
/// are not checked for collisions. Of no use once `stop` has said yes.
[[nodiscard]] StepHoles drawStepHoles(const RealArm& real, int count, std::uint64_t seed,
                                      const calibration::StopQuestion& stop = {});

struct StepTable {
  std::string reason;  ///< why there is none; empty where there is one
  int holes = 0;
  std::vector<int> counts;  ///< holes in which 0, 1, ... steps go in
  int no_posture = 0;       ///< of the holes, those that the model does not reach: no step goes in
  double median_error = std::numeric_limits<double>::quiet_NaN();  ///< m, centring, over the holes it reaches
  double p95_error = std::numeric_limits<double>::quiet_NaN();     ///< m
};

/// The model steers with its deflection compensated, its tool entering as the real arm's; the tip's place is the real
/// arm's. Of no use once `stop` has said yes.
[[nodiscard]] StepTable stepTableOf(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const RealArm& real,
                                    const StepHoles& holes, const calibration::StopQuestion& stop = {});

}  // namespace tubeplan::app
