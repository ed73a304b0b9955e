#include "planner/collision/padding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "planner/scene/regions.hpp"

namespace tubeplan::planner {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Returns the derivative of the displacement of a point with respect to a shift and a small rotation of the base. The
/// point is at `r` from the base.
Matrix36 displacementAt(const Vector3d& r) {
  Matrix36 J;
  J << Matrix3d::Identity(), (Matrix3d() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0).finished();
  return J;
}

double largestDeviation(const Matrix3d& covariance) {
  return std::sqrt(std::max(0., covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff()));
}

}  // namespace

BasePadding::BasePadding(const Workcell& cell, double sigmas)
    : sigmas_(cell.base_covariance.isZero(0) ? 0 : sigmas),
      slope_(sigmas_ * largestDeviation(cell.base_covariance.bottomRightCorner<3, 3>())),
      covariance_(cell.base_covariance),
      p_WB_(cell.X_WB.translation()),
      row_deviations_(cell.row_deviations) {}

double BasePadding::paddedBy(double base_deviation, int row) const {
  const double of_arm = row_deviations_.empty() ? 0 : row_deviations_.at(static_cast<std::size_t>(row));
  return sigmas_ * std::hypot(base_deviation, of_arm);
}

double BasePadding::of(const Capsule& body_W, int row) const {
  double deviation = 0;
  for (const Vector3d& end : {body_W.from, body_W.to}) {
    const Matrix36 J = displacementAt(end - p_WB_);
    deviation = std::max(deviation, largestDeviation(J * covariance_ * J.transpose()));
  }
  return paddedBy(deviation, row) + slope_ * body_W.radius;
}

double BasePadding::along(const Vector3d& direction_W, const Capsule& body_W, int row) const {
  double variance = 0;
  for (const Vector3d& end : {body_W.from, body_W.to}) {
    const Eigen::Matrix<double, 6, 1> slopes = displacementAt(end - p_WB_).transpose() * direction_W;
    variance = std::max(variance, slopes.dot(covariance_ * slopes));
  }
  return paddedBy(std::sqrt(std::max(0., variance)), row) + slope_ * body_W.radius;
}

double BasePadding::towards(const Shape& obstacle, const Capsule& body_W, int row) const {
  const auto* plane = dynamic_cast<const HalfSpace*>(&obstacle);
  return plane ? along(plane->normal(), body_W, row) : of(body_W, row);
}

}  // namespace tubeplan::planner
