// Statistics of samples and of the distributions of their squares, for several estimators.
#pragma once

#include <map>
#include <vector>

namespace tubeplan::calibration {

/// Returns the median; of an even number of values the upper of the middle two, of none NaN.
[[nodiscard]] double median(std::vector<double> values);

/// Returns the probabilities, one together, of alternatives with these logs of weights.
[[nodiscard]] std::vector<double> probabilitiesOf(const std::vector<double>& log_weights);

/// Upper tail of chi-square; NaN where there is no freedom.
[[nodiscard]] double chiSquareTail(double chi2, double degrees_of_freedom);

/// Returns the lower tail of chi-square: the probability that noise alone leaves as little.
[[nodiscard]] double chiSquareLowerTail(double chi2, double degrees_of_freedom);

/// Returns the value that chi-square exceeds with probability `tail`, between 0 and 1; there must be degrees of
/// freedom.
[[nodiscard]] double chiSquareQuantile(double tail, double degrees_of_freedom);

/// chiSquareQuantile() of one tail for many readings: it is computed once for each number of rows.
class ChiSquareLimit {
 public:
  explicit ChiSquareLimit(double tail) : tail_(tail) {}
  [[nodiscard]] double operator()(int degrees_of_freedom);

 private:
  double tail_;
  std::map<int, double> known_;
};

/// Returns the median of the mean of `count` squares of standard normal numbers: 0.45 for one, 0.79 for three.
[[nodiscard]] double medianOfMeanSquare(int count);

/// Returns the upper tail of Fisher's F; both numbers of degrees of freedom must be above zero.
[[nodiscard]] double fisherTail(double F, double freedom_above, double freedom_below);

}  // namespace tubeplan::calibration
