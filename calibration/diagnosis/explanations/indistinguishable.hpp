// Causes that no reading could distinguish: over the whole range of the arm they predict the same, so that they are one
// cause with several names.
#pragma once

#include <cstdint>

#include "calibration/diagnosis/explanations/explanation_model.hpp"

namespace tubeplan::calibration {

/// What an explanation predicts over the range.
struct RangeView {
  bool ok = false;
  Eigen::VectorXd value;        ///< whitened
  Eigen::MatrixXd sensitivity;  ///< by its unknowns in typical sizes
  Eigen::MatrixXd information;  ///< on them by the readings so far and by priors
};

/// Views explanations of one diagnosis over the arm's range.
class RangeViews {
 public:
  RangeViews(const FittedBasis& basis, std::uint64_t seed);
  [[nodiscard]] RangeView of(const Explanation& explanation) const;

  /// Where the explanation, as fitted, has the tip [m], reading after reading; empty where it has it nowhere.
  [[nodiscard]] Eigen::VectorXd tipsBy(const Explanation& explanation) const;

 private:
  const FittedBasis& basis_;
  std::vector<Measurement> readings_;
  ReadingWeights weights_;
};

/// Whether even readings all over the range could hardly distinguish the two, each with its numbers fitted anew to
/// them.
[[nodiscard]] bool areTheSame(const RangeView& a, const RangeView& b);

}  // namespace tubeplan::calibration
