#include "app/files/joint_units.hpp"

namespace tubeplan::app {

Dimension jointDimension(const deflection::Joint<double>& joint) {
  return joint.type == deflection::JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
}

std::string jointColumn(const deflection::Joint<double>& joint, const Units& units) {
  return joint.name + "_" + units.nameOf(jointDimension(joint));
}

Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units) {
  const auto active = deflection::activeRows(arm);
  Eigen::VectorXd factors(static_cast<Eigen::Index>(active.size()));
  for (std::size_t k = 0; k < active.size(); ++k)
    factors[static_cast<Eigen::Index>(k)] =
        units.factor(jointDimension(arm.rows[static_cast<std::size_t>(active[k])].joint));
  return factors;
}

}  // namespace tubeplan::app
