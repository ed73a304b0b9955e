// What a shape in a scene answers: how far a body is from it. The shapes themselves are in the table,
// scene_shapes.cpp.
//
// Frames: F is the frame a shape is given in (the world W for an obstacle, a link's frame L for a body).
#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "planner/scene/segment_distance.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace tubeplan::planner {

/// How near two things come. Touching is 0; inside one another is negative, and then only the sign is a promise.
struct Separation {
  double distance;        ///< m; never more than the true distance, beyond rounding
  Eigen::Vector3d point;  ///< of the body, nearest to the other thing, in the frame asked for
};

/// All points within `radius` of the segment [m].
struct Capsule {
  Eigen::Vector3d from, to;
  double radius;
};

class Solid;

/// Anything a scene is made of: a solid to keep off, or a region to stay in.
class Shape {
 public:
  virtual ~Shape() = default;

  /// How far the point p_F may move before it meets the shape [m]; negative once it is where it must not be.
  [[nodiscard]] virtual double pointDistance(const Eigen::Vector3d& p_F) const = 0;

  /// How far a body, placed at X_FB, is from the shape. The point is in frame F.
  [[nodiscard]] virtual Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const = 0;

  /// The same of a capsule given in frame F.
  [[nodiscard]] virtual Separation separationFrom(const Capsule& body_F) const = 0;

  /// Whether the shape is known to be `distance` [m] or more from the capsule, where that is found quicker than how
  /// far.
  [[nodiscard]] virtual bool isFartherThan(double /*distance*/, const Capsule& /*body_F*/) const { return false; }
};

using ShapePointer = std::shared_ptr<const Shape>;

/// A box about C's origin, its edges along C's axes.
struct Box {
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half;  ///< of its size [m]
};

/// A core in the terms of the distance library, placed in the shape's frame, with a rounding of its own around it.
/// Distance is asked between cores and the roundings taken off, so that touching bodies are still well apart for the
/// library.
struct RoundedCore {
  std::shared_ptr<const fcl::CollisionGeometry<double>> geometry;
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  double rounding = 0;  ///< m
};

/// A closed convex body.
class Solid : public Shape {
 public:
  /// The point farthest along `direction_F` (any length but zero).
  [[nodiscard]] virtual Eigen::Vector3d support(const Eigen::Vector3d& direction_F) const = 0;

  /// The point farthest from p_F.
  [[nodiscard]] virtual Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p_F) const = 0;

  /// The nearest points of a segment and the core.
  [[nodiscard]] virtual SegmentNearest nearestTo(const Eigen::Vector3d& from_F, const Eigen::Vector3d& to_F) const = 0;

  /// The solid itself, where it is a box; else null.
  [[nodiscard]] virtual const Box* box() const { return nullptr; }

  [[nodiscard]] Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override;
  [[nodiscard]] Separation separationFrom(const Capsule& body_F) const override;

  /// A capsule around the solid, and whether it is the solid itself.
  [[nodiscard]] const Capsule& around() const { return around_; }
  [[nodiscard]] bool isCapsule() const { return is_capsule_; }

  [[nodiscard]] const RoundedCore& core() const { return core_; }

 protected:
  Solid(const Capsule& around, bool is_capsule, RoundedCore core)
      : around_(around), is_capsule_(is_capsule), core_(std::move(core)) {}

 private:
  Capsule around_;
  bool is_capsule_;
  RoundedCore core_;
};

}  // namespace tubeplan::planner
