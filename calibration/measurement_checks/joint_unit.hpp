// Mistake: the values of one joint are not in the unit that its column states, such as radians in one column of a file
// in degrees.
#pragma once

#include "calibration/measurement_checks/units_of_columns.hpp"

namespace tubeplan::calibration::mistakes::joint_unit {

/// Returns the units that a joint's column may have.
inline const std::vector<NamedUnit>& unitsOf(const CheckedMeasurements& checked, int joint) {
  const bool turns = checked.start.arm.joint(joint).type == deflection::JointType::kRevolute;
  return turns ? checked.units.angle_units : checked.units.lengths;
}

inline const NamedUnit& unitOf(const CheckedMeasurements& checked, int joint) {
  return checked.units.joints.at(static_cast<std::size_t>(joint));
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> values;
  const int joints = static_cast<int>(checked.units.joints.size());
  for (int j = 0; joints > 1 && j < joints; ++j)
    for (const auto& unit : otherNames(unitsOf(checked, j), unitOf(checked, j)))
      values.push_back(checked.start.arm.joint(j).name + ":" + unit);
  return values;
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto [name, unit] = partedAtColon(value);
  const int joint = jointNamed(checked.start.arm, name);
  if (joint < 0 || joint >= static_cast<int>(checked.units.joints.size())) return std::nullopt;
  const auto factor = factorOf(unitsOf(checked, joint), unitOf(checked, joint), unit);
  if (!factor) return std::nullopt;
  Correction correction{
      "joint-unit", value,
      "the unit of " + name + " is " + unit + ", not " + unitOf(checked, joint).name + " as its column states"};
  correction.change = toEach([joint, factor = *factor](Measurement& measurement) { measurement.q[joint] *= factor; });
  return correction;
}

inline MistakeKind kind() {
  return {"joint-unit", "JOINT:UNIT", "a joint and a unit of its own kind", values, correction, false, true};
}

}  // namespace tubeplan::calibration::mistakes::joint_unit
