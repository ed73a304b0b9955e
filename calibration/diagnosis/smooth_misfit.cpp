#include "calibration/diagnosis/smooth_misfit.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "calibration/reading_prediction.hpp"
#include "calibration/span.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kRank = 1e-6;  // of the largest singular value

/// Smooth functions of a posture that no effect of a single joint's reading, taken to first order, is.
std::vector<double> functionsOf(const Measurement& reading, double heaviest) {
  std::vector<double> values;
  const VectorXd& q = reading.q;
  for (Index i = 0; i < q.size(); ++i)
    for (const int harmonic : {2, 3}) {
      values.push_back(std::sin(harmonic * q[i]));
      values.push_back(std::cos(harmonic * q[i]));
    }
  for (Index i = 0; i < q.size(); ++i)
    for (Index j = i + 1; j < q.size(); ++j) {
      values.push_back(std::sin(q[i]) * std::sin(q[j]));
      values.push_back(std::cos(q[i]) * std::sin(q[j]));
    }
  if (heaviest > 0) values.push_back((reading.load / heaviest) * (reading.load / heaviest));
  return values;
}

MatrixXd smoothColumns(const PlacedArm& placed, const std::vector<Measurement>& readings,
                       const ReadingWeights& weights) {
  double heaviest = 0;
  for (const auto& reading : readings) heaviest = std::max(heaviest, reading.load);
  const auto functions = static_cast<Index>(functionsOf(readings.front(), heaviest).size());
  const Index joints = readings.front().q.size();
  MatrixXd columns = MatrixXd::Zero(weights.rows, joints * functions);
  PredictionRequest request;
  request.by_joints = true;
  tbb::parallel_for(std::size_t{0}, readings.size(), [&](std::size_t k) {
    const auto& X_WB = placed.placings[static_cast<std::size_t>(placingOf(placed, readings[k]))].X_WB;
    const Prediction prediction = predictReading(placed.arm, X_WB, readings[k], request);
    if (!prediction.ok) return;
    const MatrixXd by_joints = weights.whitener[k] * prediction.by_joints;
    const auto values = functionsOf(readings[k], heaviest);
    for (Index f = 0; f < functions; ++f)
      columns.block(weights.first_row[k], f * joints, by_joints.rows(), joints) =
          by_joints * values[static_cast<std::size_t>(f)];
  });
  takePointsOff(weights, columns);
  return columns;
}

}  // namespace

SmoothMisfit findSmoothMisfit(const PlacedArm& placed, const std::vector<Measurement>& readings,
                              const ReadingWeights& weights, const WhitenedResidual& residual) {
  SmoothMisfit result;
  const MatrixXd Q = spanOf(residual.jacobian);
  const MatrixXd S = without(Q, smoothColumns(placed, readings, weights));
  const VectorXd rest = without(Q, residual.r);
  // The directions of the projected functions, from the eigenvectors of their Gram matrix.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(S.transpose() * S));
  const VectorXd along = eigen.eigenvectors().transpose() * (S.transpose() * rest);
  const double largest = eigen.eigenvalues().tail<1>()[0];
  for (Index k = 0; k < along.size(); ++k) {
    if (eigen.eigenvalues()[k] <= kRank * kRank * largest || eigen.eigenvalues()[k] < 1e-9) continue;
    result.fall += along[k] * along[k] / eigen.eigenvalues()[k];
    ++result.degrees_of_freedom;
  }
  const int freedom = weights.degrees_of_freedom - static_cast<int>(residual.jacobian.cols());
  if (2 * result.degrees_of_freedom > freedom) return {};  // they would follow noise as well
  result.p_value = chiSquareTail(result.fall, result.degrees_of_freedom);
  return result;
}

}  // namespace tubeplan::calibration
