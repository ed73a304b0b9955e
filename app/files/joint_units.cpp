#include "app/files/joint_units.hpp"

namespace tubeplan::app {

Dimension jointDimension(const deflection::Joint<double>& joint) {
  return joint.type == deflection::JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
}

std::string jointColumn(const deflection::Joint<double>& joint, const Units& units) {
  return joint.name + "_" + units.nameOf(jointDimension(joint));
}

Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units) {
  Eigen::VectorXd factors(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) factors[k] = units.factor(jointDimension(arm.joint(k)));
  return factors;
}

}  // namespace tubeplan::app
