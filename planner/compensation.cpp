#include "planner/compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tubeplan::planner {

namespace {

using deflection::BranchStatus, deflection::ToolGoal;
using Eigen::Vector3d, Eigen::VectorXd;

struct CompensationRow {
  Compensation mode;
  std::string_view name;
};
constexpr std::array kModes{CompensationRow{Compensation::kNone, "none"},
                            CompensationRow{Compensation::kGoalPoint, "goal-point"},
                            CompensationRow{Compensation::kViaPoint, "via-point"}};

/// Inverse kinematics of one model of the cell (the arm as it is, or rigid), goals given in the world.
class ToolPlacer {
 public:
  ToolPlacer(const Workcell& cell, deflection::Arm arm, const deflection::InverseKinematicsOptions& options)
      : cell_(cell), arm_(std::move(arm)), options_(options), gravity_B_(deflection::gravityInBase(arm_, cell.X_WB)) {}

  deflection::InverseKinematics allBranches(const Vector3d& tip_W) const {
    return solveInverseKinematics(arm_, goalAt(tip_W), cell_.load, gravity_B_, options_);
  }
  deflection::Branch near(const Vector3d& tip_W, const VectorXd& start) const {
    return refineBranch(arm_, goalAt(tip_W), cell_.load, gravity_B_, start, options_);
  }
  Vector3d tipAt(const VectorXd& q) const {
    return cell_.X_WB * solveFlexibleKinematics(arm_, {q, cell_.load, gravity_B_}).X_BD.p;
  }

 private:
  ToolGoal goalAt(const Vector3d& tip_W) const {
    return {cell_.X_WB.inverse() * tip_W, cell_.X_WB.linear().transpose() * kHoleAxis_W};
  }

  const Workcell& cell_;
  deflection::Arm arm_;
  deflection::InverseKinematicsOptions options_;
  Vector3d gravity_B_;
};

double lateral(const Vector3d& p, const Vector3d& hole) { return std::hypot(p.x() - hole.x(), p.y() - hole.y()); }

/// Via points from the goal down to the standoff at equal heights, each started from the one above. Empty when one
/// fails.
std::vector<VectorXd> viaPoints(const ToolPlacer& placer, const Vector3d& goal_W, const VectorXd& q_goal,
                                double standoff, int count, std::string& reason) {
  std::vector<VectorXd> postures{q_goal};
  for (int k = 1; k < count; ++k) {
    const auto via = placer.near(goal_W - standoff * k / (count - 1) * kHoleAxis_W, postures.back());
    if (via.status != BranchStatus::kConverged) {
      reason = "approach: " + via.reason;
      return {};
    }
    postures.push_back(via.q);
  }
  std::reverse(postures.begin(), postures.end());
  return postures;
}

/// Greatest sideways distance of the placer's own tip from the vertical through its goal, midway between via points.
double midwayDeviation(const ToolPlacer& placer, const Vector3d& goal_W, const std::vector<VectorXd>& postures) {
  double worst = 0;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k)
    worst = std::max(worst, lateral(placer.tipAt((postures[k] + postures[k + 1]) / 2), goal_W));
  return worst;
}

/// As many via points as keep the placer's tip within the tolerance of its straight line.
void addApproach(const ToolPlacer& placer, const Vector3d& goal_W, const CompensationOptions& options,
                 TubeBranch& branch) {
  for (int count = 3; count <= options.max_via_points; count = 2 * count - 1) {
    branch.approach = viaPoints(placer, goal_W, branch.q, options.standoff, count, branch.reason);
    if (branch.approach.empty()) {
      branch.status = BranchStatus::kNotConverged;
      return;
    }
    if (midwayDeviation(placer, goal_W, branch.approach) <= options.path_tolerance) return;
  }
  branch.status = BranchStatus::kNotConverged;
  branch.reason = "approach: the tip leaves the hole's axis between via points";
}

}  // namespace

std::string_view nameOf(Compensation mode) {
  return std::find_if(kModes.begin(), kModes.end(), [&](const auto& row) { return row.mode == mode; })->name;
}

std::optional<Compensation> findCompensation(std::string_view name) {
  for (const auto& row : kModes)
    if (row.name == name) return row.mode;
  return std::nullopt;
}

PredictedTip predictTip(const Workcell& cell, const VectorXd& q) {
  const auto shape =
      solveFlexibleKinematics(cell.arm, {q, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB)}, {1e-13, 100});
  const Vector3d axis_W = cell.X_WB.linear() * shape.X_BD.R * cell.arm.tool_axis_L;
  return {cell.X_WB * shape.X_BD.p, std::atan2(axis_W.cross(kHoleAxis_W).norm(), axis_W.dot(kHoleAxis_W))};
}

double lateralDeviation(const Workcell& cell, const Vector3d& hole_W, const std::vector<VectorXd>& postures,
                        int samples) {
  double worst = 0;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k)
    for (int s = 0; s <= samples; ++s) {
      const double share = static_cast<double>(s) / samples;
      worst =
          std::max(worst, lateral(predictTip(cell, (1 - share) * postures[k] + share * postures[k + 1]).p_WT, hole_W));
    }
  return worst;
}

namespace {

/// The two models that a mode works with: one for the goal, one for the way up to it.
class Modes {
 public:
  Modes(const Workcell& cell, const CompensationOptions& options)
      : cell_(cell),
        options_(options),
        flexible_(cell, cell.arm, options.inverse),
        rigid_(cell, deflection::rigidCopy(cell.arm), options.inverse) {}

  const ToolPlacer& goal() const { return options_.mode == Compensation::kNone ? rigid_ : flexible_; }
  const ToolPlacer& via() const { return options_.mode == Compensation::kViaPoint ? flexible_ : rigid_; }

  TubeBranch complete(const Vector3d& hole_W, const deflection::Branch& found) const {
    TubeBranch branch;
    branch.status = found.status;
    branch.reason = found.reason;
    branch.q = found.q;
    if (found.status != BranchStatus::kConverged) return branch;
    const PredictedTip tip = predictTip(cell_, found.q);
    branch.predicted_tip_W = tip.p_WT;
    branch.tilt = tip.tilt;
    if (!options_.with_approach) return branch;
    // The goal as the way's own model sees it: for goal-point compensation, the rigid place of the flexible goal.
    addApproach(via(), via().tipAt(found.q), options_, branch);
    if (branch.status == BranchStatus::kConverged)
      branch.path_deviation = lateralDeviation(cell_, hole_W, branch.approach);
    return branch;
  }

 private:
  const Workcell& cell_;
  const CompensationOptions& options_;
  ToolPlacer flexible_, rigid_;
};

}  // namespace

std::vector<TubeBranch> compensate(const Workcell& cell, const Vector3d& hole_W, const CompensationOptions& options) {
  const Modes modes(cell, options);
  std::vector<TubeBranch> branches;
  for (const auto& found : modes.goal().allBranches(hole_W).branches) branches.push_back(modes.complete(hole_W, found));
  return branches;
}

TubeBranch compensateFrom(const Workcell& cell, const Vector3d& hole_W, const VectorXd& q_start,
                          const CompensationOptions& options) {
  const Modes modes(cell, options);
  return modes.complete(hole_W, modes.goal().near(hole_W, q_start));
}

}  // namespace tubeplan::planner
