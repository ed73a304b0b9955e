// Uncertainty of a body's place caused by the uncertainty of the base's calibration.
//
// A point p moves by t + w x (p - p_WB) if the base has an error of a shift t and a small rotation w. Its standard
// deviation is a convex function of p, in every direction, so that none within a capsule exceeds that of the capsule's
// ends plus the rotation's part over its radius. It changes by no more than the rotation's deviation for each metre
// that p moves.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// A multiple `sigmas` of the standard deviation of a cell's base, propagated to the bodies of a posture. Const use
/// from several threads is safe.
class BasePadding {
 public:
  BasePadding() = default;
  BasePadding(const Workcell& cell, double sigmas);

  [[nodiscard]] bool isNone() const { return sigmas_ == 0; }

  /// Returns the padding of any point of the body in any direction [m].
  [[nodiscard]] double of(const Capsule& body_W) const;

  /// Returns the padding of any point of the body along a direction of unit length [m], as needed for a plane.
  [[nodiscard]] double along(const Eigen::Vector3d& direction_W, const Capsule& body_W) const;

  /// Returns the padding towards an obstacle [m]: along its normal if it is a plane.
  [[nodiscard]] double towards(const Shape& obstacle, const Capsule& body_W) const;

  /// Returns the largest change of the padding per metre that a body's point moves.
  [[nodiscard]] double slope() const { return slope_; }

 private:
  double sigmas_ = 0, slope_ = 0;
  Eigen::Matrix<double, 6, 6> covariance_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Vector3d p_WB_ = Eigen::Vector3d::Zero();
};

}  // namespace tubeplan::planner
