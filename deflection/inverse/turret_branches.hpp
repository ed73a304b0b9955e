// The closed form of turret arms. Internal to the inverse.
#pragma once

#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/rigid_tip.hpp"

namespace tubeplan::deflection {

inline constexpr int kTurretBranches = 4;  ///< front and back of the turret, elbow either way

/// Returns true if an arm of these axes is a turret arm.
[[nodiscard]] bool carriesPlane(const AxesAtZero& axes);

/// Adds the branches of turretBranches().
void addTurretBranches(const AxesAtZero& axes, const ToolGoal& goal, std::vector<Eigen::VectorXd>& branches);

}  // namespace tubeplan::deflection
