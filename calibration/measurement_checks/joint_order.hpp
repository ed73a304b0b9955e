// Mistake: two joint columns are exchanged, or several are permuted cyclically. In a cycle, the column of each joint
// contains the readings of the next joint, and the last column the readings of the first joint.
#pragma once

#include <algorithm>
#include <utility>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::joint_order {

/// Returns one value for each pair of joints of the same type; joined_mistakes.cpp tries longer cycles.
inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  const auto& arm = checked.start.arm;
  const int joints = arm.jointCount();
  for (int a = 0; a < joints; ++a)
    for (int b = a + 1; b < joints; ++b)
      if (arm.joint(a).type == arm.joint(b).type) texts.push_back(arm.joint(a).name + ":" + arm.joint(b).name);
  return texts;
}

/// Returns the indices of the joints whose names `value` lists, separated by colons; empty if a joint is unknown or
/// repeated, or if there are fewer than two.
inline std::vector<int> ringOf(const deflection::Arm& arm, const std::string& value) {
  std::vector<int> ring;
  for (const std::string& name : partedAt(':', value)) {
    const int joint = jointNamed(arm, name);
    if (joint < 0 || std::ranges::find(ring, joint) != ring.end()) return {};
    ring.push_back(joint);
  }
  return ring.size() < 2 ? std::vector<int>{} : ring;
}

/// Returns a sentence such as "the columns of theta2, theta3 and theta4 contain theta3, theta4 and theta2".
inline std::string sentenceOf(const deflection::Arm& arm, const std::vector<int>& ring) {
  const auto named = [&](std::size_t first) {
    std::string text;
    for (std::size_t k = 0; k < ring.size(); ++k)
      text += (k == 0 ? "" : k + 1 < ring.size() ? ", " : " and ") + arm.joint(ring[(first + k) % ring.size()]).name;
    return text;
  };
  return "the columns of " + named(0) + (ring.size() == 2 ? " are swapped" : " contain " + named(1) + " in this order");
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto ring = ringOf(checked.start.arm, value);
  if (ring.empty()) return std::nullopt;
  Correction correction{"joint-order", value, sentenceOf(checked.start.arm, ring)};
  correction.change = toEach([ring](Measurement& measurement) {
    for (std::size_t k = ring.size() - 1; k > 0; --k) {
      std::swap(measurement.q[ring[k]], measurement.q[ring[k - 1]]);
      if (!measurement.approach_directions.empty())
        std::swap(measurement.approach_directions[static_cast<std::size_t>(ring[k])],
                  measurement.approach_directions[static_cast<std::size_t>(ring[k - 1])]);
    }
  });
  return correction;
}

/// Returns one correction for each cycle of the permutation in which column `k` contains the readings of joint
/// `order[k]`.
inline std::vector<Correction> ringsOf(const CheckedMeasurements& checked, const std::vector<int>& order) {
  std::vector<Correction> rings;
  std::vector<bool> is_seen(order.size(), false);
  for (std::size_t first = 0; first < order.size(); ++first) {
    std::string value;
    for (std::size_t at = first; !is_seen[at]; at = static_cast<std::size_t>(order[at])) {
      is_seen[at] = true;
      value += (value.empty() ? "" : ":") + checked.start.arm.joint(static_cast<int>(at)).name;
    }
    if (auto ring = correction(checked, value)) rings.push_back(std::move(*ring));
  }
  return rings;
}

inline MistakeKind kind() {
  return {"joint-order",
          "JOINT:JOINT",
          "joints of the arm, such as theta3:theta4; with more than two, the column of each contains the readings of "
          "the next",
          values,
          correction,
          false,
          true};
}

}  // namespace tubeplan::calibration::mistakes::joint_order
