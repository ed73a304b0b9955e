// Causes that no reading could distinguish: their predictions agree over the whole range of the arm, so they are one
// cause with several names.
#pragma once

#include <cstdint>

#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// Predictions of an explanation over the arm's range.
struct RangeView {
  bool ok = false;
  Eigen::VectorXd value;        ///< whitened values
  Eigen::MatrixXd sensitivity;  ///< slopes by its unknowns, in typical sizes
  Eigen::MatrixXd information;  ///< information on the unknowns from the readings so far and from priors
};

/// Predicts by explanations of one diagnosis over the arm's range.
class RangeViews {
 public:
  RangeViews(const FittedBasis& basis, std::uint64_t seed);
  [[nodiscard]] RangeView of(const Explanation& explanation) const;

  /// Returns the positions of the tip [m] by the fitted explanation, reading after reading; empty if they cannot be
  /// computed.
  [[nodiscard]] Eigen::VectorXd tipsBy(const Explanation& explanation) const;

 private:
  const FittedBasis& basis_;
  std::vector<Measurement> readings_;
  ReadingWeights weights_;
};

/// Returns true if even readings all over the range could hardly distinguish the two, each with its numbers fitted to
/// them.
[[nodiscard]] bool areTheSame(const RangeView& a, const RangeView& b);

}  // namespace tubeplan::calibration
