// The columns of two joints exchanged.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::joint_order {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  std::vector<std::string> texts;
  const auto& arm = checked.start.arm;
  const int joints = arm.jointCount();
  for (int a = 0; a < joints; ++a)
    for (int b = a + 1; b < joints; ++b)
      if (arm.joint(a).type == arm.joint(b).type) texts.push_back(arm.joint(a).name + ":" + arm.joint(b).name);
  return texts;
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  const auto [first, second] = partedAtColon(value);
  const int a = jointNamed(checked.start.arm, first), b = jointNamed(checked.start.arm, second);
  if (a < 0 || b < 0 || a == b) return std::nullopt;
  Mend mend{"joint-order", value, "the columns of " + first + " and " + second + " are swapped"};
  mend.change = [a, b](std::vector<Measurement>& readings) {
    for (auto& reading : readings) {
      std::swap(reading.q[a], reading.q[b]);
      if (!reading.approach_directions.empty())
        std::swap(reading.approach_directions[static_cast<std::size_t>(a)],
                  reading.approach_directions[static_cast<std::size_t>(b)]);
    }
  };
  return mend;
}

inline MistakeKind kind() {
  return {"joint-order", "JOINT:JOINT", "two joints of the arm, such as theta3:theta4", values, mend, false, true};
}

}  // namespace tubeplan::calibration::mistakes::joint_order
