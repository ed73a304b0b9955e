// Statistics of samples, and the chi-square and F distributions, shared by several estimators.
#pragma once

#include <map>
#include <vector>

namespace tubeplan::calibration {

/// Returns the median, which is the upper of the middle two for an even number of values; NaN if there are no values.
[[nodiscard]] double median(std::vector<double> values);

/// Returns the normalised probabilities of alternatives, given the logarithms of their weights.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<double>& log_weights);

/// Returns the upper tail probability of the chi-square distribution; NaN if there are no degrees of freedom.
[[nodiscard]] double chiSquareTail(double chi2, double degrees_of_freedom);

/// Returns the lower tail probability of the chi-square distribution: the probability that noise alone leaves `chi2` or
/// less; NaN if there are no degrees of freedom.
[[nodiscard]] double chiSquareLowerTail(double chi2, double degrees_of_freedom);

/// Returns the value that a chi-square variable exceeds with probability `tail`, between 0 and 1. The degrees of
/// freedom must be positive.
[[nodiscard]] double chiSquareQuantile(double tail, double degrees_of_freedom);

/// Cache of chiSquareQuantile() for a fixed tail: each number of degrees of freedom is computed once.
class ChiSquareLimit {
 public:
  explicit ChiSquareLimit(double tail) : tail_(tail) {}
  [[nodiscard]] double operator()(int degrees_of_freedom);

 private:
  double tail_;
  std::map<int, double> known_;
};

/// Returns the median of the mean square of `count` standard normal variables: 0.45 for one, 0.79 for three.
[[nodiscard]] double medianOfMeanSquare(int count);

/// Returns the upper tail probability of Fisher's F distribution; both numbers of degrees of freedom must be positive.
[[nodiscard]] double fisherTail(double F, double freedom_above, double freedom_below);

}  // namespace tubeplan::calibration
