#include "planner/departure.hpp"

#include <algorithm>

#include "planner/motion/side_by_side.hpp"

namespace tubeplan::planner {

namespace {

/// Returns the waypoints straight down from `start` to `share` of the largest standoff; empty if this path
/// is not clear.
std::vector<Eigen::VectorXd> wayDown(const PlanContext& context, const Eigen::VectorXd& start, int tube, double share) {
  const Workcell& cell = context.cell;
  const TubeReachOptions& reach = context.options.reach;
  const Eigen::Vector3d hole_W = holeCentre(cell.sheet.tubes[static_cast<std::size_t>(tube)]);
  const Eigen::Vector3d tip_W = predictTip(cell, start).p_WT;
  CompensationOptions down = reach.compensation;
  down.mode = Compensation::kViaPoint;
  down.standoff = down.standoff * share + (tip_W - hole_W).dot(kHoleAxis_W) +
                  context.clearance.padding().along(kHoleAxis_W, {hole_W, hole_W, 0}, tipRow(cell.arm));
  if (!(down.standoff > 0)) return {};
  const TubeBranch branch = compensateFrom(cell, tip_W, start, down);
  if (branch.status != deflection::BranchStatus::kConverged) return {};
  std::vector<Eigen::VectorXd> waypoints(branch.approach.rbegin(), branch.approach.rend());
  waypoints.front() = start;
  if (!(context.clearance.withSpare(waypoints.back(), ContactRule::kTravel, reach.spare).margin >= 0)) return {};
  const PostureClearance margin = sideBySide(context.clearance, ContactRule::kApproach, 0);
  for (std::size_t k = 0; k + 1 < waypoints.size(); ++k)
    if (checkMotion(waypoints[k], waypoints[k + 1], margin, context.clearance.travel(), reach.check).status !=
        MotionCheckStatus::kFree)
      return {};
  return waypoints;
}

bool isWithinLimits(const deflection::Arm& arm, const Eigen::VectorXd& q) {
  for (int j = 0; j < q.size(); ++j)
    if (!(q[j] >= arm.joint(j).lower && q[j] <= arm.joint(j).upper)) return false;
  return true;
}

}  // namespace

int holeAround(const tubesheets::Sheet& sheet, const Eigen::Vector3d& p_W) {
  const auto aside = [&](const tubesheets::Tube& tube) { return (holeCentre(tube) - p_W).head<2>().norm(); };
  const auto nearest = std::ranges::min_element(sheet.tubes, {}, aside);
  if (nearest == sheet.tubes.end() || !(aside(*nearest) <= sheet.hole_diameter / 2)) return -1;
  return static_cast<int>(nearest - sheet.tubes.begin());
}

std::optional<Departure> departureFrom(const PlanContext& context) {
  const auto& start = context.options.conditions.start;
  if (!start || !isWithinLimits(context.cell.arm, *start)) return std::nullopt;
  const auto& reach = context.options.reach;
  if (context.clearance.withSpare(*start, ContactRule::kTravel, reach.spare).margin >= 0) return std::nullopt;
  const int tube = holeAround(context.cell.sheet, predictTip(context.cell, *start).p_WT);
  if (tube < 0) return std::nullopt;
  for (const double share : reach.standoff_shares)
    if (auto waypoints = wayDown(context, *start, tube, share); !waypoints.empty())
      return Departure{tube, std::move(waypoints)};
  return std::nullopt;
}

}  // namespace tubeplan::planner
