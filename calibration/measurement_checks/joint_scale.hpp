// A joint read in encoder pulses, or in any other measure that is no unit: its readings by a number that nobody stated.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurement_checks/quick_alignment.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

/// Joints whose readings go farther than any joint turns, by their indices.
[[nodiscard]] std::vector<int> jointsBeyondTurns(const CheckedReadings& checked);

/// What a joint reads at least and at most.
struct JointRange {
  double lowest = 0, highest = 0;
  [[nodiscard]] double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
};
[[nodiscard]] JointRange rangeOf(const CheckedReadings& checked, int joint);

/// How well readings, at most so many of them, fit the drawing with those of some joints multiplied.
class ScaledReadings {
 public:
  ScaledReadings(const CheckedReadings& checked, std::vector<int> joints, std::size_t most);

  /// Smaller is better; `share` as in QuickAlignmentOptions.
  [[nodiscard]] double score(const std::vector<double>& factors, double share);

 private:
  std::vector<int> joints_;
  QuickAlignment alignment_;
  std::vector<Measurement> readings_;
};

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::joint_scale
