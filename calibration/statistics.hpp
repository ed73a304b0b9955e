// What several estimators ask of a sample and of the distributions of its squares.
#pragma once

#include <map>
#include <vector>

namespace tubeplan::calibration {

/// Of an even number the upper of the two in the middle; NaN of none.
[[nodiscard]] double median(std::vector<double> values);

/// Upper tail of chi-square; NaN where there is no freedom.
[[nodiscard]] double chiSquareTail(double chi2, double degrees_of_freedom);

/// The lower tail: how often noise alone leaves as little.
[[nodiscard]] double chiSquareLowerTail(double chi2, double degrees_of_freedom);

/// The value that chi-square exceeds with probability `tail`, between 0 and 1; there must be freedom.
[[nodiscard]] double chiSquareQuantile(double tail, double degrees_of_freedom);

/// chiSquareQuantile of one tail for readings of so many rows, which are many: each number of rows is worked out once.
class ChiSquareLimit {
 public:
  explicit ChiSquareLimit(double tail) : tail_(tail) {}
  [[nodiscard]] double operator()(int degrees_of_freedom);

 private:
  double tail_;
  std::map<int, double> known_;
};

/// Median of the mean of so many squares of standard normal numbers: 0.45 of one, 0.79 of three.
[[nodiscard]] double medianOfMeanSquare(int count);

/// Upper tail of Fisher's F; there must be freedom above and below.
[[nodiscard]] double fisherTail(double F, double freedom_above, double freedom_below);

}  // namespace tubeplan::calibration
