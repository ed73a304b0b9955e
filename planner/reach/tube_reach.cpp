#include "planner/reach/tube_reach.hpp"

#include <algorithm>
#include <cassert>

#include "planner/motion/side_by_side.hpp"
#include "planner/reach/insertion.hpp"

namespace tubeplan::planner {

namespace {

/// Test that a branch failed, in the order of the tests. The failure of a later test is more informative.
enum class Hurdle { kNone, kKinematics, kStandoff, kApproach, kTube };

struct BranchVerdict {
  Hurdle failed = Hurdle::kNone;
  std::string reason;
  Clearance blocking;
};

/// Tilts that differ by less than this are treated as equal [rad]; a quarter of a degree.
constexpr double kSameTilt = 0.0044;

/// Smallest number of joints with which an arm controls its tilt: three for the tip's position, two more for the tilt.
constexpr Eigen::Index kJointsThatTilt = 5;

/// Removes branches that are tilted more than the most upright branch. An arm with fewer than kJointsThatTilt joints
/// does not control its tilt, so that all its branches are kept.
void keepUpright(const deflection::Arm& arm, std::vector<TubeBranch>& branches) {
  if (branches.size() < 2 || arm.jointCount() < kJointsThatTilt) return;
  const double least = std::ranges::min_element(branches, {}, &TubeBranch::tilt)->tilt;
  std::erase_if(branches, [&](const TubeBranch& branch) { return branch.tilt > least + kSameTilt; });
}

std::string inTheWay(const Clearance& clearance) {
  if (clearance.body.empty()) return clearance.other;
  return clearance.body + " comes too near " + clearance.other;
}

BranchVerdict judge(const ArmClearance& clearance, const Eigen::Vector3d& hole_W, const TubeBranch& branch,
                    const TubeReachOptions& options) {
  if (branch.status != deflection::BranchStatus::kConverged) return {Hurdle::kKinematics, branch.reason, {}};
  const Clearance at_standoff = clearance.withSpare(branch.approach.front(), ContactRule::kTravel, options.spare);
  if (!(at_standoff.margin >= 0))
    return {Hurdle::kStandoff, "collision below the hole: " + inTheWay(at_standoff), at_standoff};
  const PostureClearance margin = sideBySide(clearance, ContactRule::kApproach, options.spare);
  for (std::size_t k = 0; k + 1 < branch.approach.size(); ++k) {
    const auto check =
        checkMotion(branch.approach[k], branch.approach[k + 1], margin, clearance.travel(), options.check);
    if (check.status != MotionCheckStatus::kFree)
      return {Hurdle::kApproach, "approach blocked: " + inTheWay(check.tightest), check.tightest};
  }
  if (!(playInTube(clearance.cell(), hole_W, branch.approach) >= 0))
    return {
        Hurdle::kTube, "the tool would touch the tube before that depth: its tilt or centring error is too large", {}};
  return {};
}

/// Returns the reach of a tube with one of the standoffs to try.
TubeReach reachFrom(double share, const ArmClearance& clearance, int tube, const TubeReachOptions& options) {
  TubeReach reach;
  reach.tube = tube;
  reach.status = ReachStatus::kUnreachable;
  reach.reason = "the place is out of the arm's reach";
  Hurdle furthest = Hurdle::kNone;
  const Workcell& cell = clearance.cell();
  const Eigen::Vector3d hole_W = holeCentre(cell.sheet.tubes.at(tube));
  // `options.compensation.standoff` is measured from the face, the standoff of compensate() from the goal.
  CompensationOptions compensation = options.compensation;
  compensation.standoff *= share;
  compensation.standoff +=
      cell.insertion + clearance.padding().along(kHoleAxis_W, {hole_W, hole_W, 0}, tipRow(cell.arm));
  for (auto& branch : compensate(cell, visitPlace(cell, cell.sheet.tubes.at(tube)), compensation)) {
    const BranchVerdict verdict = judge(clearance, hole_W, branch, options);
    if (verdict.failed == Hurdle::kNone) {
      reach.branches.push_back(std::move(branch));
    } else if (verdict.failed > furthest) {
      furthest = verdict.failed;
      reach.reason = verdict.reason;
      reach.blocking = verdict.blocking;
    }
  }
  if (reach.branches.empty()) return reach;
  keepUpright(cell.arm, reach.branches);
  reach.status = ReachStatus::kReachable;
  reach.reason.clear();
  return reach;
}

}  // namespace

TubeReach reachTube(const ArmClearance& clearance, int tube, const TubeReachOptions& options) {
  assert(options.compensation.with_approach && !options.standoff_shares.empty());
  TubeReach reach;
  for (const double share : options.standoff_shares) {
    reach = reachFrom(share, clearance, tube, options);
    if (reach.status == ReachStatus::kReachable) break;
  }
  return reach;
}

}  // namespace tubeplan::planner
