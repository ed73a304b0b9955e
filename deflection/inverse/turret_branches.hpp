// The closed form of turret arms. Internal to the inverse kinematics.
#pragma once

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

/// Largest number of branches: turret facing front or back, elbow up or down.
inline constexpr int kTurretBranches = 4;

/// Returns true if an arm with these axes is a turret arm.
[[nodiscard]] bool carriesPlane(const AxesAtZero& axes);

/// Adds the postures that turretBranches() returns.
void addTurretBranches(const AxesAtZero& axes, const ToolGoal& goal, std::vector<Eigen::VectorXd>& branches);

}  // namespace tubeplan::deflection
