#include "calibration/diagnosis/smooth_misfit.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "calibration/reading_prediction.hpp"

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

/// Takes the touched points' estimates off columns, as off the residual.
void projectPoints(const ReadingWeights& weights, MatrixXd& columns) {
  for (const auto& point : weights.points) {
    MatrixXd stacked(3 * static_cast<Index>(point.readings.size()), columns.cols());
    for (std::size_t i = 0; i < point.readings.size(); ++i)
      stacked.middleRows(3 * static_cast<Index>(i), 3) =
          columns.middleRows(weights.first_row[static_cast<std::size_t>(point.readings[i])], 3);
    stacked -= (point.Q * (point.Q.transpose() * stacked)).eval();
    for (std::size_t i = 0; i < point.readings.size(); ++i)
      columns.middleRows(weights.first_row[static_cast<std::size_t>(point.readings[i])], 3) =
          stacked.middleRows(3 * static_cast<Index>(i), 3);
  }
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
  projectPoints(weights, columns);
  return columns;
}

}  // namespace

SmoothMisfit findSmoothMisfit(const PlacedArm& placed, const std::vector<Measurement>& readings,
                              const ReadingWeights& weights, const WhitenedResidual& residual) {
  SmoothMisfit result;
  MatrixXd S = smoothColumns(placed, readings, weights);
  VectorXd rest = residual.r;
  const MatrixXd& J = residual.jacobian;
  if (J.cols() > 0) {
    const MatrixXd Q =
        MatrixXd(Eigen::HouseholderQR<MatrixXd>(J).householderQ() * MatrixXd::Identity(J.rows(), J.cols()));
    S -= (Q * (Q.transpose() * S)).eval();
    rest -= (Q * (Q.transpose() * rest)).eval();
  }
  // The directions of the projected functions, from the eigenvectors of their Gram matrix.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(S.transpose() * S));
  const VectorXd along = eigen.eigenvectors().transpose() * (S.transpose() * rest);
  const double largest = eigen.eigenvalues().tail<1>()[0];
  for (Index k = 0; k < along.size(); ++k) {
    if (eigen.eigenvalues()[k] <= kRank * kRank * largest || eigen.eigenvalues()[k] < 1e-9) continue;
    result.fall += along[k] * along[k] / eigen.eigenvalues()[k];
    ++result.degrees_of_freedom;
  }
  const int freedom = weights.degrees_of_freedom - static_cast<int>(J.cols());
  if (2 * result.degrees_of_freedom > freedom) return {};  // they would follow noise as well
  result.p_value = chiSquareTail(result.fall, result.degrees_of_freedom);
  return result;
}

}  // namespace tubeplan::calibration
