// Causes that no reading could distinguish: their predictions agree over the whole range of the arm, so they count as
// one cause with several names.
#pragma once

#include <cstdint>

#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// Predictions of an explanation over the arm's range.
struct RangeView {
  bool ok = false;
  Eigen::VectorXd value;  ///< whitened residuals of virtual readings over the range
  /// Derivatives of `value` with respect to the explanation's unknowns, in units of their typical sizes.
  Eigen::MatrixXd sensitivity;
  Eigen::MatrixXd information;  ///< information on the unknowns from the readings so far and from priors
};

/// Virtual readings over the arm's range, at which the explanations of one diagnosis are compared.
class RangeViews {
 public:
  RangeViews(const FittedBasis& basis, std::uint64_t seed);
  [[nodiscard]] RangeView of(const Explanation& explanation) const;

  /// Returns the tip positions [m] predicted by the fitted explanation, stacked for all virtual readings; empty if they
  /// cannot be computed.
  [[nodiscard]] Eigen::VectorXd tipsBy(const Explanation& explanation) const;

 private:
  const FittedBasis& basis_;
  std::vector<Measurement> readings_;
  ReadingWeights weights_;
};

/// Returns true if readings over the arm's whole range could hardly distinguish the two explanations, even if the
/// parameters of each are refitted.
[[nodiscard]] bool areTheSame(const RangeView& a, const RangeView& b);

}  // namespace tubeplan::calibration
