// Conversion between tool positions in the world and joint readings, for one model of a cell.
#pragma once

#include <vector>

#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/kinematics.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// Converts tip positions to postures and back, with the flexible or the rigid arm. The tool points along the holes'
/// axis as closely as the arm can. `cell` and `arm` must outlive this object.
class ToolPlacer {
 public:
  ToolPlacer(const Workcell& cell, const deflection::Arm& arm, const deflection::InverseKinematicsOptions& options);

  [[nodiscard]] std::vector<deflection::Branch> allBranches(const Eigen::Vector3d& tip_W);

  /// Returns one branch for each tip position [m], found from the start posture with the same index.
  [[nodiscard]] std::vector<deflection::Branch> near(const std::vector<Eigen::Vector3d>& tips_W,
                                                     const std::vector<Eigen::VectorXd>& starts);

  /// Returns the tip position of each posture in the world [m]; NaN if the shape does not converge.
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
