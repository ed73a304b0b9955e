// Mistake: the readings of a joint are in encoder pulses or in another unknown unit, so their scale factor is
// unknown.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurement_checks/quick_alignment.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

/// Returns the indices of joints whose readings exceed the range of any real joint.
[[nodiscard]] std::vector<int> jointsBeyondTurns(const CheckedMeasurements& checked);

/// Lowest and highest reading of a joint [internal units].
struct JointRange {
  double lowest = 0, highest = 0;
  [[nodiscard]] double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
};
[[nodiscard]] JointRange rangeOf(const CheckedMeasurements& checked, int joint);

/// Comparison of at most `most` measurements with the rigid arm as drawn, with the readings of each of `joints`
/// multiplied by a trial factor.
class ScaledMeasurements {
 public:
  ScaledMeasurements(const CheckedMeasurements& checked, std::vector<int> joints, std::size_t most);

  /// Returns the score for these factors, one per joint; a smaller score is a better fit. `share` is
  /// QuickAlignmentOptions::share.
  [[nodiscard]] double score(const std::vector<double>& factors, double share);

 private:
  std::vector<int> joints_;
  QuickAlignment alignment_;
  std::vector<Measurement> measurements_;
};

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::joint_scale
