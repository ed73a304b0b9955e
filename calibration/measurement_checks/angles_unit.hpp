// Mistake: joint readings are in radians although their columns state degrees, or vice versa. Readings of prismatic
// joints are not affected.
#pragma once

#include "calibration/measurement_checks/units_of_columns.hpp"

namespace tubeplan::calibration::mistakes::angles_unit {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  return otherNames(checked.units.angle_units, checked.units.angles);
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto factor = factorOf(checked.units.angle_units, checked.units.angles, value);
  if (!factor) return std::nullopt;
  Correction correction{
      "angles", value,
      "the unit of the joint readings is " + value + ", not " + checked.units.angles.name + " as their columns state"};
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(checked.start.arm.jointCount());
  for (Eigen::Index j = 0; j < factors.size(); ++j)
    if (checked.start.arm.joint(j).type == deflection::JointType::kRevolute) factors[j] = *factor;
  correction.change = [factors](std::vector<Measurement>& measurements) {
    for (auto& measurement : measurements) measurement.q = measurement.q.cwiseProduct(factors);
  };
  return correction;
}

inline MistakeKind kind() { return {"angles", "UNIT", "a unit of angle", values, correction}; }

}  // namespace tubeplan::calibration::mistakes::angles_unit
