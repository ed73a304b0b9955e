// Distance of readings from the rigid drawing with the base at its best place. It takes microseconds, so that thousands
// of corrections can be compared and only a few are fitted.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

struct QuickAlignmentOptions {
  bool frees_base = false;
  double share = 1;  ///< share of a hundredth of the reach, below which errors count as zero
  /// Score above which no greater accuracy is needed.
  double promising = std::numeric_limits<double>::infinity();
};

/// Alignment of rigid tips with measured places. Each thread needs its own object.
class QuickAlignment {
 public:
  /// Prepares the alignment for an arm with this `reach` [m].
  QuickAlignment(const PlacedArm& start, double reach);

  /// Returns the tips in the base frame [m], one for each reading; undefined for readings that state no place.
  [[nodiscard]] std::vector<Eigen::Vector3d> tips(const std::vector<Measurement>& readings);

  /// Returns the mean of half the logarithm of one plus the squared error over the square of what counts as zero;
  /// infinite if too few readings state a place. An unknown base is placed in closed form, with weights that decrease
  /// with the error if the score is promising; a penalty for its distance from the nominal place is included.
  [[nodiscard]] double score(const std::vector<Measurement>& readings, const std::vector<Eigen::Vector3d>& tips,
                             const QuickAlignmentOptions& options = {}) const;

 private:
  PlacedArm rigid_;
  deflection::PreparedArm arm_;
  double blind_;
};

}  // namespace tubeplan::calibration
