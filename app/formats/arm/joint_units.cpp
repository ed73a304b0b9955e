#include "app/formats/arm/joint_units.hpp"

#include <set>
#include <string>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

Dimension jointDimension(const deflection::Joint<double>& joint) {
  return joint.type == deflection::JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
}

std::string jointColumnName(const deflection::Joint<double>& joint) {
  static const std::set<std::string> kTaken = [] {
    std::set<std::string> taken;
    for (const ColumnTarget& target : columnTargets({}))
      if (target.unit) taken.insert(target.quantity);
    return taken;
  }();
  return kTaken.contains(joint.name) ? "joint_" + joint.name : joint.name;
}

std::string jointColumn(const deflection::Joint<double>& joint, const Units& units) {
  return jointColumnName(joint) + "_" + units.nameOf(jointDimension(joint));
}

Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units) {
  Eigen::VectorXd factors(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) factors[k] = units.factor(jointDimension(arm.joint(k)));
  return factors;
}

}  // namespace tubeplan::app
