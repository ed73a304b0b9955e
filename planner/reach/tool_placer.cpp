#include "planner/reach/tool_placer.hpp"

#include <algorithm>

#include "planner/reach/compensation.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

deflection::InverseKinematicsOptions withinTilt(const tubesheets::SteppedTool& tool,
                                                deflection::InverseKinematicsOptions options) {
  options.max_tilt = std::min(options.max_tilt, tubesheets::toleratedTilt(tool));
  return options;
}

}  // namespace

ToolPlacer::ToolPlacer(const Workcell& cell, const deflection::Arm& arm,
                       const deflection::InverseKinematicsOptions& options)
    : cell_(cell),
      joints_(arm.jointCount()),
      gravity_B_(deflection::gravityInBase(arm, cell.X_WB)),
      solver_(arm, cell.load, gravity_B_, withinTilt(cell.tool, options)),
      kinematics_(arm) {}

std::vector<deflection::Branch> ToolPlacer::allBranches(const Vector3d& tip_W) {
  return std::move(solver_.solve(goalAt(tip_W)).branches);
}

std::vector<deflection::Branch> ToolPlacer::near(const std::vector<Vector3d>& tips_W,
                                                 const std::vector<VectorXd>& starts) {
  goals_.clear();
  for (const Vector3d& tip_W : tips_W) goals_.push_back(goalAt(tip_W));
  return solver_.refine(goals_, starts);
}

std::vector<Vector3d> ToolPlacer::tipsAt(const std::vector<VectorXd>& postures) {
  const auto n = static_cast<Eigen::Index>(postures.size());
  batch_.resize(joints_, n, cell_.load, gravity_B_);
  for (Eigen::Index k = 0; k < n; ++k) batch_.q.col(k) = postures[static_cast<std::size_t>(k)];
  kinematics_.solve(batch_, tips_);
  std::vector<Vector3d> tips_W;
  for (Eigen::Index k = 0; k < n; ++k) tips_W.push_back(cell_.X_WB * Vector3d(tips_.poses.col(k).head<3>()));
  return tips_W;
}

deflection::ToolGoal ToolPlacer::goalAt(const Vector3d& tip_W) const {
  return {cell_.X_WB.inverse() * tip_W, cell_.X_WB.linear().transpose() * kHoleAxis_W};
}

}  // namespace tubeplan::planner
