// The closed form of turret arms. Internal to the inverse kinematics.
#pragma once

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

inline constexpr int kTurretBranches = 4;  ///< largest number: turret facing front or back, elbow either way

/// Returns true if an arm with these axes is a turret arm.
[[nodiscard]] bool carriesPlane(const AxesAtZero& axes);

/// Adds the postures that turretBranches() returns.
void addTurretBranches(const AxesAtZero& axes, const ToolGoal& goal, std::vector<Eigen::VectorXd>& branches);

}  // namespace tubeplan::deflection
