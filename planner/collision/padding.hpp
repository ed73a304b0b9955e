// How far a body may stand from where the model has it, by the uncertainty of the base's calibration.
//
// A point p moves by t + w x (p - p_WB) where the base is off by a shift t and a small turn w. Its standard deviation
// is a convex function of p, in every direction, so that none within a capsule exceeds that of the capsule's ends and
// what the turn adds over its radius. It changes by no more than the turn's deviation for each metre that p moves.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// `sigmas` standard deviations of the base of a cell, as the bodies of a posture feel them. Const use from several
/// threads is safe.
class BasePadding {
 public:
  BasePadding() = default;
  BasePadding(const Workcell& cell, double sigmas);

  [[nodiscard]] bool isNone() const { return sigmas_ == 0; }

  /// m, of any point of the body in any direction.
  [[nodiscard]] double of(const Capsule& body_W) const;

  /// m, of any point of the body along a direction of unit length: what a plane asks for.
  [[nodiscard]] double along(const Eigen::Vector3d& direction_W, const Capsule& body_W) const;

  /// Towards an obstacle: along its normal where it is a plane.
  [[nodiscard]] double towards(const Shape& obstacle, const Capsule& body_W) const;

  /// m for each metre that a body's point moves, at most.
  [[nodiscard]] double slope() const { return slope_; }

 private:
  double sigmas_ = 0, slope_ = 0;
  Eigen::Matrix<double, 6, 6> covariance_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Vector3d p_WB_ = Eigen::Vector3d::Zero();
};

}  // namespace tubeplan::planner
