// Mistake: the reading of a joint contains the angle of another joint, as on controllers that show the elbow relative
// to the horizontal, or with a parallel linkage. With the value theta3:theta2:-1, the angle of the arm's joint theta3
// is column theta3 minus column theta2 of the measurements.
#pragma once

#include <fmt/format.h>

#include "calibration/measurement_checks/mistake.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::joint_coupling {

/// Returns two values for every ordered pair of revolute joints: the second joint's reading is subtracted from the
/// first joint's, or added to it. Neighbouring joints come first.
inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  const auto& arm = checked.start.arm;
  std::vector<std::string> texts;
  for (int separation = 1; separation < arm.jointCount(); ++separation)
    for (const int j : turningJoints(arm))
      for (const int of : {j - separation, j + separation}) {
        if (of < 0 || of >= arm.jointCount() || arm.joint(of).type != deflection::JointType::kRevolute) continue;
        for (const int share : {-1, 1})
          texts.push_back(fmt::format("{}:{}:{}", arm.joint(j).name, arm.joint(of).name, share));
      }
  return texts;
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto [joints, number] = partedAtColon(value);
  const auto [name, of_name] = partedAtColon(joints);
  const int joint = jointNamed(checked.start.arm, name), of = jointNamed(checked.start.arm, of_name);
  const double share = tubesheets::parseNumber(number).value_or(0);
  if (joint < 0 || of < 0 || joint == of || share == 0) return std::nullopt;
  const std::string shown = share == -1  ? name + " + " + of_name
                            : share == 1 ? name + " - " + of_name
                                         : fmt::format("{} - {:g} {}", name, share, of_name);
  Correction correction{"joint-coupling", value,
                        "the column of " + name + " contains " + shown + " of the arm's joints"};
  correction.change =
      toEach([joint, of, share](Measurement& measurement) { measurement.q[joint] += share * measurement.q[of]; });
  return correction;
}

inline MistakeKind kind() {
  return {"joint-coupling",
          "JOINT:JOINT:SHARE",
          "a joint, another and the share of its reading to add, such as theta3:theta2:-1",
          values,
          correction,
          false,
          true};
}

}  // namespace tubeplan::calibration::mistakes::joint_coupling
