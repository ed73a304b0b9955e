// Mistake: the readings of a joint are in encoder pulses or in another measure without a unit, so they have an unknown
// scale factor.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurement_checks/quick_alignment.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

/// Returns the indices of joints whose readings exceed the range of any real joint.
[[nodiscard]] std::vector<int> jointsBeyondTurns(const CheckedReadings& checked);

/// Lowest and highest reading of a joint [internal units].
struct JointRange {
  double lowest = 0, highest = 0;
  [[nodiscard]] double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
};
[[nodiscard]] JointRange rangeOf(const CheckedReadings& checked, int joint);

/// Deviation of at most `most` readings from the rigid drawing, with the readings of some joints multiplied by factors.
class ScaledReadings {
 public:
  ScaledReadings(const CheckedReadings& checked, std::vector<int> joints, std::size_t most);

  /// Returns the score for these factors, smaller for a better fit; `share` is QuickAlignmentOptions::share.
  [[nodiscard]] double score(const std::vector<double>& factors, double share);

 private:
  std::vector<int> joints_;
  QuickAlignment alignment_;
  std::vector<Measurement> readings_;
};

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::joint_scale
