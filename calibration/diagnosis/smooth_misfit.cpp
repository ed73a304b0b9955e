#include "calibration/diagnosis/smooth_misfit.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "calibration/reading_prediction.hpp"
#include "calibration/span.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kRank = 1e-6;  // of the largest singular value
constexpr double kSeen = 1e-9;  // squared length of a signature that is none

/// Smooth functions of a posture that no effect of a single joint's reading, taken to first order, is. Pairs of them
/// belong together: two phases of one wave.
std::vector<Eigen::Vector2d> functionsOf(const Measurement& reading, double heaviest) {
  std::vector<Eigen::Vector2d> values;
  const VectorXd& q = reading.q;
  for (Index i = 0; i < q.size(); ++i)
    for (const int harmonic : {2, 3}) values.emplace_back(std::sin(harmonic * q[i]), std::cos(harmonic * q[i]));
  for (Index i = 0; i < q.size(); ++i)
    for (Index j = i + 1; j < q.size(); ++j)
      values.emplace_back(std::sin(q[i]) * std::sin(q[j]), std::cos(q[i]) * std::sin(q[j]));
  if (heaviest > 0) values.emplace_back((reading.load / heaviest) * (reading.load / heaviest), 0);
  return values;
}

/// The least p-value of one wave on one joint alone, for as many looks as there are waves (Sidak).
double chanceOfOneWave(const MatrixXd& gram, const VectorXd& along, Index waves) {
  double least = 1;
  for (Index wave = 0; wave < waves; ++wave) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(gram.block<2, 2>(2 * wave, 2 * wave));
    const Eigen::Vector2d turned = eigen.eigenvectors().transpose() * along.segment<2>(2 * wave);
    double fall = 0;
    int degrees = 0;
    for (int k = 0; k < 2; ++k) {
      if (!(eigen.eigenvalues()[k] > kSeen)) continue;
      fall += turned[k] * turned[k] / eigen.eigenvalues()[k];
      ++degrees;
    }
    if (degrees > 0) least = std::min(least, chiSquareTail(fall, degrees));
  }
  return -std::expm1(static_cast<double>(waves) * std::log1p(-std::min(least, 1 - 1e-12)));
}

MatrixXd smoothColumns(const PlacedArm& placed, const std::vector<Measurement>& readings,
                       const ReadingWeights& weights) {
  double heaviest = 0;
  for (const auto& reading : readings) heaviest = std::max(heaviest, reading.load);
  const auto functions = static_cast<Index>(functionsOf(readings.front(), heaviest).size());
  const Index joints = readings.front().q.size();
  MatrixXd columns = MatrixXd::Zero(weights.rows, 2 * joints * functions);
  PredictionRequest request;
  request.by_joints = true;
  tbb::parallel_for(std::size_t{0}, readings.size(), [&](std::size_t k) {
    const auto& X_WB = placed.placings[static_cast<std::size_t>(placingOf(placed, readings[k]))].X_WB;
    const Prediction prediction = predictReading(placed.arm, X_WB, readings[k], request);
    if (!prediction.ok) return;
    const MatrixXd by_joints = weights.whitener[k] * prediction.by_joints;
    const auto values = functionsOf(readings[k], heaviest);
    for (Index f = 0; f < functions; ++f)
      for (Index j = 0; j < joints; ++j)
        columns.block(weights.first_row[k], 2 * (f * joints + j), by_joints.rows(), 2) =
            by_joints.col(j) * values[static_cast<std::size_t>(f)].transpose();
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
  const MatrixXd gram = S.transpose() * S;
  const VectorXd right = S.transpose() * rest;
  const double one_wave = chanceOfOneWave(gram, right, gram.rows() / 2);
  // The directions of the projected functions, from the eigenvectors of their Gram matrix.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const VectorXd along = eigen.eigenvectors().transpose() * right;
  const double largest = eigen.eigenvalues().tail<1>()[0];
  for (Index k = 0; k < along.size(); ++k) {
    if (eigen.eigenvalues()[k] <= kRank * kRank * largest || eigen.eigenvalues()[k] < kSeen) continue;
    result.fall += along[k] * along[k] / eigen.eigenvalues()[k];
    ++result.degrees_of_freedom;
  }
  // Against many functions at once, few readings say nothing: they would follow noise as well.
  const int freedom = weights.degrees_of_freedom - static_cast<int>(residual.jacobian.cols());
  const bool are_few = 2 * result.degrees_of_freedom > freedom;
  const double together = are_few ? 1 : chiSquareTail(result.fall, result.degrees_of_freedom);
  result.p_value = std::min(1., 2 * std::min(together, one_wave));
  return result;
}

}  // namespace tubeplan::calibration
