#include "calibration/estimation/robust_loss.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// Returns the weight factor of a measurement; `length` is the length of its whitened residual divided by the typical
/// length.
double robustFactor(double length, RobustLoss loss) {
  if (loss == RobustLoss::kNone) return 1;
  return loss == RobustLoss::kHuber ? (length > 1.6 ? 1.6 / length : 1) : 1 / (1 + length * length / 6);
}

/// Returns the expected fraction of a measurement's chi-square that is left after robust weighting, for normal noise.
double shareLeft(int rows, RobustLoss loss) {
  constexpr int kSteps = 400;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double square = chiSquareQuantile((k + 0.5) / kSteps, rows);
    sum += square * robustFactor(std::sqrt(square / rows), loss);
  }
  return sum / kSteps / rows;
}

}  // namespace

VectorXd robustFactors(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                       const WhitenedResidual& residual, const VectorXd& old, RobustLoss loss) {
  VectorXd size(static_cast<Index>(measurements.size()));
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const double weight = old.size() ? old[static_cast<Index>(k)] : 1;
    size[static_cast<Index>(k)] = residual.r.segment(weights.first_row[k], rowsOf(measurements[k])).norm() /
                                  std::sqrt(weight * rowsOf(measurements[k]));
  }
  std::vector<double> sizes;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    sizes.push_back(size[static_cast<Index>(k)] / std::sqrt(medianOfMeanSquare(rowsOf(measurements[k]))));
  const double spread = std::max(1., median(std::move(sizes)));
  VectorXd factors(size.size());
  for (Index k = 0; k < size.size(); ++k) factors[k] = robustFactor(size[k] / spread, loss);
  return factors;
}

double comparableChi2(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                      const VectorXd& r, RobustLoss loss) {
  if (loss == RobustLoss::kNone) return r.squaredNorm();
  std::map<int, double> shares;
  double chi2 = 0;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const int rows = rowsOf(measurements[k]);
    if (!shares.contains(rows)) shares[rows] = shareLeft(rows, loss);
    chi2 += r.segment(weights.first_row[k], rows).squaredNorm() / shares[rows];
  }
  return chi2;
}

}  // namespace tubeplan::calibration
