// Reachability of tubes: the usable branches of the arm at a tube, or the reason why there are none.
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
  /// The scene's clearance is increased by this number of standard deviations of the base's pose. A standoff is lowered
  /// by the same number of deviations along the hole's axis, so that `compensation.standoff` remains.
  double padding = 0;
  /// Standoffs to try at each tube, as fractions of `compensation.standoff`, ascending. The first one with a usable
  /// branch is taken, which keeps the vertical moves short.
  std::vector<double> standoff_shares = {1};
  double spare = 5.08e-4;  ///< reserve that a plan keeps beyond the scene's clearance [m] (0.020 in)
};

enum class ReachStatus { kNotRun, kReachable, kUnreachable };

struct TubeReach {
  ReachStatus status = ReachStatus::kNotRun;
  int tube = -1;  ///< index of the tube in the sheet
  /// Usable branches: they reach the hole within the joint limits, and are clear at the hole and during the whole
  /// approach.
  std::vector<TubeBranch> branches;
  std::string reason;  ///< failure of the branch that passed the most tests; empty if there is a usable branch
  Clearance blocking;  ///< pair of bodies that collides, if the failure is a collision
};

[[nodiscard]] TubeReach reachTube(const ArmClearance& clearance, int tube, const TubeReachOptions& options = {});

}  // namespace tubeplan::planner
