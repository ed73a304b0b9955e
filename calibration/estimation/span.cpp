#include "calibration/estimation/span.hpp"

#include <Eigen/QR>

namespace tubeplan::calibration {

using Eigen::MatrixXd;

namespace {

constexpr double kRank = 1e-8;  // a unit column adds to the rank if its norm outside the span exceeds this

}  // namespace

Eigen::VectorXd partOutsideSpan(const MatrixXd& columns, const Eigen::VectorXd& vector) {
  if (columns.cols() == 0) return vector;
  return vector - columns * columns.completeOrthogonalDecomposition().solve(vector);
}

MatrixXd spanOf(MatrixXd columns) {
  if (columns.size() == 0) return MatrixXd(columns.rows(), 0);
  for (auto column : columns.colwise())
    if (column.norm() > 0) column.normalize();
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(kRank);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

MatrixXd without(const MatrixXd& Q, const MatrixXd& columns) {
  return Q.cols() == 0 ? columns : MatrixXd(columns - Q * (Q.transpose() * columns));
}

}  // namespace tubeplan::calibration
