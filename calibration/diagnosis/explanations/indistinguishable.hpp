// Causes that no measurement could distinguish: their predictions agree over the whole range of the arm, so they are
// treated as one cause with several names.
#pragma once

#include <cstdint>

#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// Predictions of an explanation over the arm's range.
struct RangeView {
  bool ok = false;
  Eigen::VectorXd value;  ///< whitened residuals of virtual measurements over the range
  /// Derivatives of `value` with respect to the explanation's unknowns, in units of their typical sizes.
  Eigen::MatrixXd sensitivity;
  Eigen::MatrixXd information;  ///< information on the unknowns from the measurements so far and from priors
};

/// Virtual measurements over the arm's range, at which the explanations of one diagnosis are compared.
class RangeViews {
 public:
  RangeViews(const FittedBasis& basis, std::uint64_t seed);
  [[nodiscard]] RangeView of(const Explanation& explanation) const;

  /// Returns the tip positions [m] predicted by the fitted explanation, stacked for all virtual measurements; empty if
  /// they cannot be computed.
  [[nodiscard]] Eigen::VectorXd tipsBy(const Explanation& explanation) const;

 private:
  const FittedBasis& basis_;
  std::vector<Measurement> measurements_;
  MeasurementWeights weights_;
};

/// Returns true if measurements over the arm's whole range could hardly distinguish the two explanations, even if the
/// parameters of each are refitted.
[[nodiscard]] bool areTheSame(const RangeView& a, const RangeView& b);

}  // namespace tubeplan::calibration
