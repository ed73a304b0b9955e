// Uncertainty of a body's position caused by the uncertainty of the base's calibration and of the arm's parameters.
//
// If the base is wrong by a shift t and a small rotation w, a point p moves by t + w x (p - p_WB). The standard
// deviation of this motion, in every direction, is a convex function of p. Within a capsule it therefore never exceeds
// its value at the capsule's ends plus the rotation's standard deviation times the capsule's radius. Per metre that p
// moves, it changes by no more than the rotation's standard deviation. The arm's parameters add a constant variance for
// each row (Workcell::row_deviations), which does not increase the rate of change.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// Padding of the distances of bodies: `sigmas` times the standard deviation of the body's position in a posture. The
/// argument `row` is the row of the arm that carries the body. Const use from several threads is safe.
class BasePadding {
 public:
  BasePadding() = default;
  BasePadding(const Workcell& cell, double sigmas);

  [[nodiscard]] bool isNone() const { return sigmas_ == 0; }

  /// Returns an upper bound of the padding of any point of the body in any direction [m].
  [[nodiscard]] double of(const Capsule& body_W, int row) const;

  /// Returns an upper bound of the padding of any point of the body along a unit vector [m], as needed for a plane.
  [[nodiscard]] double along(const Eigen::Vector3d& direction_W, const Capsule& body_W, int row) const;

  /// Returns the padding towards an obstacle [m]: along the obstacle's normal if it is a plane, else in any direction.
  [[nodiscard]] double towards(const Shape& obstacle, const Capsule& body_W, int row) const;

  /// Returns the largest change of the padding per metre of motion of a body's point [m/m].
  [[nodiscard]] double slope() const { return slope_; }

 private:
  /// Returns the padding of a body of the row [m]; `base_deviation` is the standard deviation caused by the base [m].
  [[nodiscard]] double paddedBy(double base_deviation, int row) const;

  double sigmas_ = 0, slope_ = 0;
  Eigen::Matrix<double, 6, 6> covariance_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Vector3d p_WB_ = Eigen::Vector3d::Zero();
  std::vector<double> row_deviations_;
};

}  // namespace tubeplan::planner
