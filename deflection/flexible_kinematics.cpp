#include "deflection/flexible_kinematics.hpp"

#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

FlexibleKinematics solveFlexibleKinematics(const Arm& arm, const Posture& posture,
                                           const FlexibleKinematicsOptions& options) {
  PreparedArm prepared(arm);
  prepared.solve(posture, options);
  return prepared.shape();
}

std::vector<Eigen::Isometry3d> rowFramesInWorld(const FlexibleKinematics& kinematics, const Eigen::Isometry3d& X_WB) {
  std::vector<Eigen::Isometry3d> frames;
  frames.reserve(kinematics.rows.size());
  for (const auto& row : kinematics.rows) frames.push_back(X_WB * toIsometry(row.X_BL));
  return frames;
}

}  // namespace tubeplan::deflection
