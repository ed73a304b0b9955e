#include "calibration/estimation/outliers.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Error of a measurement relative to a fit that excludes it.
struct Alone {
  VectorXd error;     // error of the measurement [m]
  double square = 0;  // error^T covariance^-1 error: chi-square with one degree of freedom per row
};

/// Returns for each measurement its rows of the matrix Q of its unknown point; empty for measurements without an
/// unknown point.
std::vector<MatrixXd> pointBlocks(const MeasurementWeights& weights, std::size_t measurements) {
  std::vector<MatrixXd> blocks(measurements);
  for (const auto& point : weights.points)
    for (std::size_t i = 0; i < point.measurements.size(); ++i) {
      const Index rows = point.Q.rows() / static_cast<Index>(point.measurements.size());
      blocks[static_cast<std::size_t>(point.measurements[i])] = point.Q.middleRows(rows * static_cast<Index>(i), rows);
    }
  return blocks;
}

/// Returns the error of a measurement relative to a fit without it. Let H be the measurement's block of the projection
/// onto the fitted unknowns. The error is then (I - H)^-1 r and its covariance (I - H)^-1, both whitened. The weight
/// factor f of a robust fit is removed: the measurement's own part of the covariance stays I, the part due to other
/// measurements is divided by f.
Alone judgeAlone(const VectorXd& r, const MatrixXd& H, double factor, const MatrixXd& covariance) {
  const Index n = r.size();
  const auto factored = (MatrixXd::Identity(n, n) - H).completeOrthogonalDecomposition();
  const VectorXd error = factored.solve(r) / std::sqrt(factor);
  const MatrixXd others = (factored.solve(MatrixXd::Identity(n, n)) - MatrixXd::Identity(n, n)) / factor;
  const MatrixXd spread = MatrixXd::Identity(n, n) + others;
  return {covariance.llt().matrixL() * error, error.dot(spread.ldlt().solve(error))};
}

std::vector<Alone> judgeAll(const std::vector<Measurement>& measurements, const Fit& fit) {
  const auto points = pointBlocks(fit.weights, measurements.size());
  const MatrixXd& J = fit.residual.jacobian;
  std::vector<Alone> all;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    const Index row = fit.weights.first_row[k], rows = rowsOf(measurements[k]);
    MatrixXd H = MatrixXd::Zero(rows, rows);
    if (J.cols()) H += J.middleRows(row, rows) * fit.covariance * J.middleRows(row, rows).transpose();
    if (points[k].size()) H += points[k] * points[k].transpose();
    const double factor = fit.factors.size() ? fit.factors[static_cast<Index>(k)] : 1;
    all.push_back(judgeAlone(fit.residual.r.segment(row, rows), H, factor, fit.weights.covariance(k)));
  }
  return all;
}

/// Returns the square of the factor by which the typical error exceeds the noise, but at least 1.
double usualSquare(const std::vector<Measurement>& measurements, const std::vector<Alone>& all) {
  std::vector<double> sizes;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int rows = rowsOf(measurements[k]);
    sizes.push_back(all[k].square / (rows * medianOfMeanSquare(rows)));
  }
  return std::max(1., median(std::move(sizes)));
}

}  // namespace

std::vector<Outlier> findOutliers(const std::vector<Measurement>& measurements, const Fit& fit, double level) {
  const auto all = judgeAll(measurements, fit);
  std::vector<Outlier> outliers;
  if (all.empty()) return outliers;
  const double usual = usualSquare(measurements, all);
  ChiSquareLimit limitOf(level / static_cast<double>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].square > limitOf(rowsOf(measurements[k])) * usual)
      outliers.push_back({static_cast<int>(k), all[k].error.norm(), std::sqrt(all[k].square)});
  }
  std::ranges::stable_sort(outliers, std::greater{}, &Outlier::sigmas);
  return outliers;
}

}  // namespace tubeplan::calibration
