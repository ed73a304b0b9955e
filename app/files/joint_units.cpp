#include "app/files/joint_units.hpp"

#include <set>
#include <string_view>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

Dimension jointDimension(const deflection::Joint<double>& joint) {
  return joint.type == deflection::JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
}

std::string jointColumnName(const deflection::Joint<double>& joint) {
  static const std::set<std::string_view> kTaken = [] {
    std::set<std::string_view> taken{
        "id",      "kind",    "point",    "setup",    "split",    "from",    "row",        "load",        "force_x",
        "force_y", "force_z", "moment_x", "moment_y", "moment_z", "x",       "y",          "z",           "tool_x",
        "tool_y",  "tool_z",  "sigma",    "sigma_x",  "sigma_y",  "sigma_z", "turn_sigma", "temperature", "time"};
    for (const auto& kind : calibration::measurementKinds())
      for (const auto& column : kind.columns) taken.insert(column.name);
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
