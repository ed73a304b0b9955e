// The regions in the table of scene shapes (scene_shapes.cpp), for code that depends on the kind of region.
#pragma once

#include <algorithm>

#include "planner/scene/shape.hpp"

namespace tubeplan::planner {

/// The inside of a sphere as a region; its distance is exact for every body.
class SphereInterior : public Shape {
 public:
  SphereInterior(const Eigen::Vector3d& centre, double radius) : centre_(centre), radius_(radius) {}

  double pointDistance(const Eigen::Vector3d& p) const override { return radius_ - (p - centre_).norm(); }
  Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override {
    const Eigen::Vector3d farthest = X_FB * body.farthestFrom(X_FB.inverse() * centre_);
    return {pointDistance(farthest), farthest};
  }
  Separation separationFrom(const Capsule& body) const override {
    const bool to_end = (body.to - centre_).squaredNorm() > (body.from - centre_).squaredNorm();
    const Eigen::Vector3d& end = to_end ? body.to : body.from;
    const double distance = (end - centre_).norm();
    const Eigen::Vector3d outwards =
        distance > 0 ? Eigen::Vector3d((end - centre_) / distance) : Eigen::Vector3d::UnitX();
    return {radius_ - distance - body.radius, end + body.radius * outwards};
  }

  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }

 private:
  Eigen::Vector3d centre_;
  double radius_;
};

/// The half space on the side of a plane that the normal points to; its distance is exact for every body.
class HalfSpace : public Shape {
 public:
  HalfSpace(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
      : point_(point), normal_(normal.normalized()) {}

  double pointDistance(const Eigen::Vector3d& p) const override { return normal_.dot(p - point_); }
  Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override {
    const Eigen::Vector3d lowest = X_FB * body.support(X_FB.linear().transpose() * -normal_);
    return {pointDistance(lowest), lowest};
  }
  Separation separationFrom(const Capsule& body) const override {
    const double from = pointDistance(body.from), to = pointDistance(body.to);
    return {std::min(from, to) - body.radius, (to < from ? body.to : body.from) - body.radius * normal_};
  }

  [[nodiscard]] const Eigen::Vector3d& point() const { return point_; }
  [[nodiscard]] const Eigen::Vector3d& normal() const { return normal_; }  ///< normal of length 1

 private:
  Eigen::Vector3d point_, normal_;
};

}  // namespace tubeplan::planner
