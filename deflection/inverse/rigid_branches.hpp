// All rigid postures that bring the tip to a place with the tool along an axis: the starts of the flexible solution.
#pragma once

#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::deflection {

/// Where the tool shall be, in the base frame: tip place [m] and unit direction that the tool's axis shall have.
struct ToolGoal {
  Eigen::Vector3d p_BT = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_B = Eigen::Vector3d::UnitZ();
};

/// True for four revolute joints of which the last three are parallel within 5 degrees: a turret that carries a plane
/// 3R arm.
bool isTurretArm(const Arm& arm);

/// Closed form for a turret arm: at most four joint vectors (front and back of the turret, elbow either way), exact
/// where the three axes are parallel, otherwise near; a goal just beyond the rigid reach gets starts near it. Angles in
/// (-pi, pi]. Empty: out of reach. Calkins' Cobra is such an arm.
std::vector<Eigen::VectorXd> turretBranches(const Arm& arm, const ToolGoal& goal);

/// A deterministic low-discrepancy lattice over the joint limits (one turn where there are none).
std::vector<Eigen::VectorXd> latticeStarts(const Arm& arm, int count);

}  // namespace tubeplan::deflection
