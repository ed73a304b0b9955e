// Which tubes the arm can serve, in which branches, and why not the others.
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
  /// Standard deviations of the base's place, kept beyond the scene's clearance. A standoff is further below its hole
  /// by what they come to there: `compensation.standoff` is what is left of it.
  double padding = 0;
  double spare = 5.08e-4;  ///< m beyond the scene's clearance that a plan keeps in hand (0.020 in)
};

enum class ReachStatus { kNotRun, kReachable, kUnreachable };

struct TubeReach {
  ReachStatus status = ReachStatus::kNotRun;
  int tube = -1;                     ///< index in the sheet
  std::vector<TubeBranch> branches;  ///< usable: reach the hole, within limits, clear at the hole and all the way up
  std::string reason;                ///< when there is none: what stops the branch that came furthest
  Clearance blocking;                ///< the pair in the way, where that is a collision
};

[[nodiscard]] TubeReach reachTube(const ArmClearance& clearance, int tube, const TubeReachOptions& options = {});

}  // namespace tubeplan::planner
