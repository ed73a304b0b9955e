// How far readings are from where the drawing, taken as rigid, would have them, with the base where it suits them best:
// in microseconds, to choose among thousands of ways to take them those worth a fit.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

struct QuickAlignmentOptions {
  bool frees_base = false;
  double share = 1;  ///< of a hundredth of the reach: errors below it count as none
  double promising = std::numeric_limits<double>::infinity();  ///< score that is not asked for more exactly than so
};

/// Each thread needs its own.
class QuickAlignment {
 public:
  /// `reach` of the arm [m].
  QuickAlignment(const PlacedArm& start, double reach);

  /// Tips in the base frame [m], one for each reading; of those that state no place nothing is to be read.
  [[nodiscard]] std::vector<Eigen::Vector3d> tips(const std::vector<Measurement>& readings);

  /// Mean of half the logarithm of one and the squares of the errors over what counts as none; infinite where too few
  /// readings state a place. A base that is not known is placed by a closed form, with weights that fall with the
  /// errors where the score is promising, and what its distance from the nominal place has against it counts.
  [[nodiscard]] double score(const std::vector<Measurement>& readings, const std::vector<Eigen::Vector3d>& tips,
                             const QuickAlignmentOptions& options = {}) const;

 private:
  PlacedArm rigid_;
  deflection::PreparedArm arm_;
  double blind_;
};

}  // namespace tubeplan::calibration
