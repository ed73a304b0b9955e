#include "planner/collision/padding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "planner/scene/regions.hpp"

namespace tubeplan::planner {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Returns the Jacobian of the displacement of a point at `r` from the base with respect to a shift and a small
/// rotation of the base.
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
      p_WB_(cell.X_WB.translation()) {}

double BasePadding::of(const Capsule& body_W) const {
  double deviation = 0;
  for (const Vector3d& end : {body_W.from, body_W.to}) {
    const Matrix36 J = displacementAt(end - p_WB_);
    deviation = std::max(deviation, largestDeviation(J * covariance_ * J.transpose()));
  }
  return sigmas_ * deviation + slope_ * body_W.radius;
}

double BasePadding::along(const Vector3d& direction_W, const Capsule& body_W) const {
  double variance = 0;
  for (const Vector3d& end : {body_W.from, body_W.to}) {
    const Eigen::Matrix<double, 6, 1> row = displacementAt(end - p_WB_).transpose() * direction_W;
    variance = std::max(variance, row.dot(covariance_ * row));
  }
  return sigmas_ * std::sqrt(std::max(0., variance)) + slope_ * body_W.radius;
}

double BasePadding::towards(const Shape& obstacle, const Capsule& body_W) const {
  const auto* plane = dynamic_cast<const HalfSpace*>(&obstacle);
  return plane ? along(plane->normal(), body_W) : of(body_W);
}

}  // namespace tubeplan::planner
