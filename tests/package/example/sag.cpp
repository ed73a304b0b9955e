// Sag of a horizontal arm of one link under a load at the tip.
#include <cstdio>

#include "deflection/flexible_kinematics.hpp"

int main() {
  tubeplan::deflection::Arm arm;
  auto& row = arm.rows.emplace_back();
  row.name = "link";
  row.placement = tubeplan::deflection::Origin<double>{{0, 0, 1}, {1.5707963267948966, 0, 0}};
  row.joint = {.name = "shoulder", .type = tubeplan::deflection::JointType::kRevolute};
  row.joint_stiffness.z() = 1e5;  // [N m/rad]
  arm.p_LT = {2, 0, 0};           // [m]
  const auto shape = tubeplan::deflection::solveFlexibleKinematics(arm, {Eigen::VectorXd::Zero(1), 50});
  std::printf("%.6f\n", shape.X_BD.p.z() - 1);
}
