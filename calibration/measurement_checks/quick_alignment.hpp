// Distance between measured positions and the tips of the rigid arm as drawn, with the base at its best pose. The
// computation takes microseconds, so thousands of corrections can be compared before the best few are fitted.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

struct QuickAlignmentOptions {
  bool frees_base = false;
  double share = 1;  ///< scale b of the errors in score(), relative to a hundredth of the reach
  /// The alignment of the base is refined only if the score is below this value.
  double promising = std::numeric_limits<double>::infinity();
};

/// Alignment of the rigid arm's tips with the measured positions. Each thread needs a separate object.
class QuickAlignment {
 public:
  /// Prepares the alignment for an arm with this `reach` [m].
  QuickAlignment(const PlacedArm& start, double reach);

  /// Returns the tip positions in the base frame [m], one for each measurement; NaN for measurements that state no
  /// position.
  [[nodiscard]] std::vector<Eigen::Vector3d> tips(const std::vector<Measurement>& measurements);

  /// Returns the mean over all measurements of log(1 + e^2 / b^2) / 2, where e is the error and b the scale below which
  /// errors are negligible. Infinite if too few measurements state a position. An unknown base is placed in closed
  /// form; if the score is then below `promising`, the placement is repeated with weights that decrease with the error.
  /// The score of an unknown base includes a penalty for its distance from its nominal place.
  [[nodiscard]] double score(const std::vector<Measurement>& measurements, const std::vector<Eigen::Vector3d>& tips,
                             const QuickAlignmentOptions& options = {}) const;

 private:
  PlacedArm rigid_;
  deflection::PreparedArm arm_;
  double blind_;
};

}  // namespace tubeplan::calibration
