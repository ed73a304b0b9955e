// Postures of the rigid arm with the tip at a position and the tool along an axis, from which the flexible solution
// starts.
#pragma once

#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// Goal of the tool in the base frame: position of the tip [m] and unit direction of the tool axis.
struct ToolGoal {
  Eigen::Vector3d p_BT = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_B = Eigen::Vector3d::UnitZ();
};

/// Returns true for four revolute joints with the last three parallel within 5 degrees: a turret that carries a planar
/// 3R arm.
bool isTurretArm(const Arm& arm);

/// Returns the closed-form solutions for a turret arm, such as Calkins' Cobra: at most four joint vectors (front and
/// back of the turret, elbow either way), with angles in (-pi, pi]. The solutions are exact if the last three axes are
/// parallel, otherwise approximate. For a goal just beyond the rigid reach, postures near the goal are returned; for
/// one out of reach, none.
std::vector<Eigen::VectorXd> turretBranches(const Arm& arm, const ToolGoal& goal);

/// Returns `count` postures of a deterministic low-discrepancy lattice within the joint limits. Without limits, a
/// revolute joint covers one turn and a prismatic joint twice the reach.
std::vector<Eigen::VectorXd> latticeStarts(const Arm& arm, int count);

}  // namespace tubeplan::deflection
