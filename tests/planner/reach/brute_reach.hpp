// Reachability of a tube, tested with random starts: one of them must lead to a free posture below the tube and a free
// motion up.
#pragma once

#include "planner/motion/side_by_side.hpp"
#include "planner/reach/tube_reach.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner::testing {

inline bool servesFreely(const ArmClearance& clearance, const TubeBranch& branch, const TubeReachOptions& options) {
  if (branch.status != deflection::BranchStatus::kConverged) return false;
  if (!(clearance.withSpare(branch.approach.front(), ContactRule::kTravel, options.spare).margin >= 0)) return false;
  const PostureClearance margin = sideBySide(clearance, ContactRule::kApproach, options.spare);
  for (std::size_t k = 0; k + 1 < branch.approach.size(); ++k)
    if (checkMotion(branch.approach[k], branch.approach[k + 1], margin, clearance.travel(), options.check).status !=
        MotionCheckStatus::kFree)
      return false;
  return true;
}

/// Returns true if one of `starts` random starts reaches the tube. Only for a cell whose tool stays below the face.
inline bool isReachedByBruteForce(const ArmClearance& clearance, int tube, int starts) {
  const Workcell& cell = clearance.cell();
  const TubeReachOptions options;
  std::mt19937_64 generator(static_cast<std::uint64_t>(tube));
  for (int k = 0; k < starts; ++k)
    if (servesFreely(clearance,
                     compensateFrom(cell, holeOf(cell, tube), randomPosture(cell.arm, generator), options.compensation),
                     options))
      return true;
  return false;
}

}  // namespace tubeplan::planner::testing
