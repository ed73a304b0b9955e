// Implementation of modelErrorOf(), which estimates the error of the model itself in addition to the noise.
#include <algorithm>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Probability that noise alone makes a measurement look like a gross error.
constexpr double kGrossErrorLevel = 0.01;

/// Squared errors of measurements relative to the sum of their noise variance and an additional variance of every
/// coordinate.
class ErrorVariance {
 public:
  ErrorVariance(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                const VectorXd& error) {
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(weights.noise[k]);
      noise_.push_back(axes.eigenvalues().cwiseMax(0));
      squares_.push_back(
          (axes.eigenvectors().transpose() * error.segment(weights.first_row[k], rowsOf(measurements[k]))).cwiseAbs2());
    }
  }

  /// Returns the mean over a measurement's rows of its squared error divided by the noise variance plus `variance`.
  [[nodiscard]] double meanSquare(std::size_t measurement, double variance) const {
    return (squares_[measurement].array() / (noise_[measurement].array() + variance)).mean();
  }

  /// Returns the root of the function `size`, which decreases with the variance; 0 if size(0) is not positive.
  template <class Size>
  [[nodiscard]] double solve(const Size& size) const {
    if (!(size(0.) > 0)) return 0;
    double low = 0, high = 0;
    for (const auto& squares : squares_) high = std::max(high, squares.maxCoeff());
    for (high *= 4; size(high) > 0; high *= 4) low = high;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (size(middle) > 0 ? low : high) = middle;
    }
    return high;
  }

  /// Returns the median of meanSquare() over the measurements, divided by the median expected for normal noise.
  [[nodiscard]] double usualSquare(double variance) const {
    std::vector<double> squares;
    for (std::size_t k = 0; k < squares_.size(); ++k)
      squares.push_back(meanSquare(k, variance) / medianOfMeanSquare(static_cast<int>(squares_[k].size())));
    return median(std::move(squares));
  }

 private:
  std::vector<VectorXd> noise_, squares_;
};

}  // namespace

double modelErrorOf(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                    const VectorXd& error, int degrees_of_freedom) {
  if (degrees_of_freedom <= 0) return 0;
  const ErrorVariance errors(measurements, weights, error);
  // Errors far above the typical one are gross errors, which the model does not cause, so they are excluded.
  const double usual = errors.solve([&](double v) { return errors.usualSquare(v) - 1; });
  ChiSquareLimit limitOf(kGrossErrorLevel / static_cast<double>(measurements.size()));
  std::vector<std::size_t> kept;
  int freedom = degrees_of_freedom;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const int rows = rowsOf(measurements[k]);
    if (rows * errors.meanSquare(k, usual) <= limitOf(rows))
      kept.push_back(k);
    else
      freedom -= rows;
  }
  if (freedom <= 0) return 0;
  const auto chi2At = [&](double variance) {
    double chi2 = 0;
    for (const std::size_t k : kept) chi2 += rowsOf(measurements[k]) * errors.meanSquare(k, variance);
    return chi2;
  };
  if (!(chiSquareTail(chi2At(0), freedom) < kLackOfFit)) return 0;
  return std::sqrt(errors.solve([&](double v) { return chi2At(v) - freedom; }));
}

}  // namespace tubeplan::calibration
