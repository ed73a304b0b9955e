// The shipped Cobra arm, random joint vectors within the limits of an arm, and random directions.
#pragma once

#include <numbers>
#include <random>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "tests/units.hpp"

namespace tubeplan::deflection {

inline Arm cobraArm(int segments = 1) {
  static const Arm kArm = app::readArm(app::readYamlFile(TUBEPLAN_SOURCE_DIR "/app/cells/cobra-arm.yaml").root).arm;
  Arm arm = kArm;
  for (auto& row : arm.rows)
    if (row.beam) row.beam->segments = segments;
  arm.tool_axis_L = Eigen::Vector3d::UnitY();
  return arm;
}

inline Eigen::VectorXd randomJoints(const Arm& arm, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.02, 0.98);
  Eigen::VectorXd q(arm.jointCount());
  for (int k = 0; k < q.size(); ++k) {
    const auto& joint = arm.joint(k);
    q[k] = joint.lower + share(random) * (joint.upper - joint.lower);
  }
  return q;
}

inline Eigen::Vector3d randomDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, 1);
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace tubeplan::deflection
