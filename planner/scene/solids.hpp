// The solids in the table of scene shapes (scene_shapes.cpp), for code that depends on the kind of solid.
#pragma once

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <cmath>

#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

/// Returns the pose with its origin midway between `from` and `to`, and z pointing from `from` to `to`.
inline Eigen::Isometry3d poseAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = 0.5 * (from + to);
  if (from != to)
    X.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to - from).toRotationMatrix();
  return X;
}

/// A capsule; a sphere if both ends are the same point.
class CapsuleSolid : public Solid {
 public:
  explicit CapsuleSolid(const Capsule& capsule) : Solid(capsule, true, coreOf(capsule)) {}

  double pointDistance(const Eigen::Vector3d& p) const override {
    return (nearestPoints(around().from, around().to, p, p).on_a - p).norm() - around().radius;
  }
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const override {
    const bool to_end = direction.dot(around().to - around().from) > 0;
    return (to_end ? around().to : around().from) + around().radius * direction.normalized();
  }
  Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p) const override {
    const bool to_end = (around().to - p).squaredNorm() > (around().from - p).squaredNorm();
    const Eigen::Vector3d end = to_end ? around().to : around().from;
    return end == p ? Eigen::Vector3d(p + around().radius * Eigen::Vector3d::UnitX())
                    : Eigen::Vector3d(end + around().radius * (end - p).normalized());
  }
  SegmentNearest nearestTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const auto [on_solid, on_segment] = nearestPoints(around().from, around().to, from, to);
    return {on_segment, on_solid};
  }

 private:
  static RoundedCore coreOf(const Capsule& capsule) {
    const double length = (capsule.to - capsule.from).norm();
    RoundedCore core{nullptr, poseAlong(capsule.from, capsule.to), capsule.radius};
    if (length > 0)
      core.geometry = std::make_shared<fcl::Capsuled>(0.0, length);
    else
      core.geometry = std::make_shared<fcl::Sphered>(0.0);
    return core;
  }
};

class BoxSolid : public Solid {
 public:
  BoxSolid(const Eigen::Isometry3d& X_FC, const Eigen::Vector3d& size)
      : Solid(aroundBox(X_FC, size), false, {std::make_shared<fcl::Boxd>(size), X_FC, 0}), box_{X_FC, 0.5 * size} {}

  double pointDistance(const Eigen::Vector3d& p) const override {
    const Eigen::Vector3d beyond = (box_.X_FC.inverse() * p).cwiseAbs() - box_.half;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  }
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const override {
    return box_.X_FC * corner(box_.X_FC.linear().transpose() * direction);
  }
  Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p) const override {
    return box_.X_FC * corner(-(box_.X_FC.inverse() * p));
  }
  SegmentNearest nearestTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const Eigen::Isometry3d X_CF = box_.X_FC.inverse();
    const auto [on_segment, on_solid] = nearestToBox(X_CF * from, X_CF * to, box_.half);
    return {box_.X_FC * on_segment, box_.X_FC * on_solid};
  }
  const Box* box() const override { return &box_; }

 private:
  Eigen::Vector3d corner(const Eigen::Vector3d& towards) const {
    return box_.half.binaryExpr(towards, [](double half, double sign) { return std::copysign(half, sign); });
  }
  static Capsule aroundBox(const Eigen::Isometry3d& X_FC, const Eigen::Vector3d& size) {
    Eigen::Index longest = 0;
    const double length = size.maxCoeff(&longest);
    const Eigen::Vector3d half_axis = 0.5 * length * X_FC.linear().col(longest);
    const double radius = 0.5 * std::sqrt(std::max(0.0, size.squaredNorm() - length * length));
    return {X_FC.translation() - half_axis, X_FC.translation() + half_axis, radius * (1 + 1e-12)};
  }

  Box box_;
};

/// A cylinder with flat ends.
class CylinderSolid : public Solid {
 public:
  CylinderSolid(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius)
      : Solid({from, to, radius}, false,
              {std::make_shared<fcl::Cylinderd>(radius, (to - from).norm()), poseAlong(from, to), 0}),
        X_FC_(core().X_FC),
        radius_(radius),
        half_length_(0.5 * (to - from).norm()) {}

  double pointDistance(const Eigen::Vector3d& p) const override {
    const Eigen::Vector3d p_C = X_FC_.inverse() * p;
    const Eigen::Vector2d beyond(p_C.head<2>().norm() - radius_, std::abs(p_C.z()) - half_length_);
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
  }
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const override {
    return X_FC_ * rim(X_FC_.linear().transpose() * direction);
  }
  Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p) const override { return X_FC_ * rim(-(X_FC_.inverse() * p)); }
  SegmentNearest nearestTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const Eigen::Isometry3d X_CF = X_FC_.inverse();
    const auto [on_segment, on_solid] = nearestToCylinder(X_CF * from, X_CF * to, radius_, half_length_);
    return {X_FC_ * on_segment, X_FC_ * on_solid};
  }

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double halfLength() const { return half_length_; }

 private:
  Eigen::Vector3d rim(const Eigen::Vector3d& towards) const {
    const double across = towards.head<2>().norm();
    const Eigen::Vector2d sideways =
        across > 0 ? Eigen::Vector2d(towards.head<2>() / across) : Eigen::Vector2d::UnitX();
    return {radius_ * sideways.x(), radius_ * sideways.y(), std::copysign(half_length_, towards.z())};
  }

  Eigen::Isometry3d X_FC_;
  double radius_, half_length_;
};

}  // namespace tubeplan::planner
