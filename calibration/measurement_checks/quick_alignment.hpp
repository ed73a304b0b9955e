// How far readings are from where the drawing, taken as rigid, would have them, with the base where it suits them best:
// in microseconds, to choose among thousands of ways to take them those worth a fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

class QuickAlignment {
 public:
  /// `reach` of the arm [m].
  QuickAlignment(const PlacedArm& start, double reach);

  /// Tips in the base frame [m], one for each reading; of those that state no place nothing is to be read.
  [[nodiscard]] std::vector<Eigen::Vector3d> tips(const std::vector<Measurement>& readings) const;

  /// Mean logarithm of one and the errors over what counts as none, a hundredth of the reach times `share`; infinite
  /// where too few readings state a place. A base that is not known is placed by a robust closed form.
  [[nodiscard]] double score(const std::vector<Measurement>& readings, const std::vector<Eigen::Vector3d>& tips,
                             bool frees_base = false, double share = 1) const;

 private:
  PlacedArm rigid_;
  double blind_;
};

}  // namespace tubeplan::calibration
