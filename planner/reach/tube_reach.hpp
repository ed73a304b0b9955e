// Tubes that the arm can serve, with their branches, and reasons for the others.
#pragma once

#include <string>
#include <vector>

#include "planner/collision/arm_clearance.hpp"
#include "planner/motion/motion_check.hpp"
#include "planner/reach/compensation.hpp"

namespace tubeplan::planner {

struct TubeReachOptions {
  CompensationOptions compensation;
  MotionCheckOptions check;
  /// Number of standard deviations of the base's place, kept beyond the scene's clearance. A standoff is further below
  /// its hole by their size there, so that `compensation.standoff` remains.
  double padding = 0;
  double spare = 5.08e-4;  ///< reserve of a plan beyond the scene's clearance [m] (0.020 in)
};

enum class ReachStatus { kNotRun, kReachable, kUnreachable };

struct TubeReach {
  ReachStatus status = ReachStatus::kNotRun;
  int tube = -1;  ///< index in the sheet
  /// Usable ones: reach the hole, within limits, clear at the hole and during the whole approach.
  std::vector<TubeBranch> branches;
  std::string reason;  ///< obstacle to the branch that came furthest, if there is no usable one
  Clearance blocking;  ///< pair in the way, if that is a collision
};

[[nodiscard]] TubeReach reachTube(const ArmClearance& clearance, int tube, const TubeReachOptions& options = {});

}  // namespace tubeplan::planner
