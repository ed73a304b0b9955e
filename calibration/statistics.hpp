// Statistics of samples, and the chi-square and F distributions, shared by several estimators.
#pragma once

#include <map>
#include <vector>

namespace tubeplan::calibration {

/// Returns the median: for an even number of values, the larger of the middle two; NaN if there are no values.
[[nodiscard]] double median(std::vector<double> values);

/// Returns the probabilities of alternatives, which add up to 1, given the logarithms of their unnormalised weights.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<double>& log_weights);

/// Returns the probability that a chi-square variable exceeds `chi2`; NaN if there are no degrees of freedom.
[[nodiscard]] double chiSquareTail(double chi2, double degrees_of_freedom);

/// Returns the probability that a chi-square variable is at most `chi2`; NaN if there are no degrees of freedom.
[[nodiscard]] double chiSquareLowerTail(double chi2, double degrees_of_freedom);

/// Returns the value that a chi-square variable exceeds with probability `tail`, between 0 and 1. The degrees of
/// freedom must be positive.
[[nodiscard]] double chiSquareQuantile(double tail, double degrees_of_freedom);

/// Computes chiSquareQuantile() at a fixed tail probability, once for each number of degrees of freedom.
class ChiSquareLimit {
 public:
  explicit ChiSquareLimit(double tail) : tail_(tail) {}
  [[nodiscard]] double operator()(int degrees_of_freedom);

 private:
  double tail_;
  std::map<int, double> known_;
};

/// Returns the median of the distribution of the mean square of `count` standard normal variables: 0.45 for one
/// variable, 0.79 for three.
[[nodiscard]] double medianOfMeanSquare(int count);

/// Returns the probability that a variable with Fisher's F distribution exceeds `F`. The degrees of freedom of
/// numerator (`freedom_above`) and denominator (`freedom_below`) must be positive.
[[nodiscard]] double fisherTail(double F, double freedom_above, double freedom_below);

}  // namespace tubeplan::calibration
