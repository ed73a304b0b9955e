// Places of the tool in the world as joint readings, and joint readings as places of its tip: of one model of a cell.
#pragma once

#include <vector>

#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/kinematics.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// The arm as it is, or rigid: both outlive the placer. The tool points along the holes' axis as far as the arm can.
class ToolPlacer {
 public:
  ToolPlacer(const Workcell& cell, const deflection::Arm& arm, const deflection::InverseKinematicsOptions& options);

  [[nodiscard]] std::vector<deflection::Branch> allBranches(const Eigen::Vector3d& tip_W);

  /// From a start near each.
  [[nodiscard]] std::vector<deflection::Branch> near(const std::vector<Eigen::Vector3d>& tips_W,
                                                     const std::vector<Eigen::VectorXd>& starts);

  /// In the world; not numbers where the shape does not converge.
  [[nodiscard]] std::vector<Eigen::Vector3d> tipsAt(const std::vector<Eigen::VectorXd>& postures);

 private:
  [[nodiscard]] deflection::ToolGoal goalAt(const Eigen::Vector3d& tip_W) const;

  const Workcell& cell_;
  Eigen::Index joints_;
  Eigen::Vector3d gravity_B_;
  deflection::InverseSolver solver_;
  deflection::Kinematics kinematics_;
  std::vector<deflection::ToolGoal> goals_;
  deflection::PostureBatch batch_;
  deflection::TipBatch tips_;
};

}  // namespace tubeplan::planner
