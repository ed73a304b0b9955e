// The interface of shapes in a scene, which computes the distance of a body from a shape. The shapes themselves are in
// the table in scene_shapes.cpp.
//
// Frame F is the frame in which a shape is given: the world W for an obstacle, a link's frame L for a body.
#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "planner/scene/segment_distance.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace tubeplan::planner {

/// Distance between two shapes: 0 if they touch, negative if they overlap; only the sign of a negative distance is
/// meaningful.
struct Separation {
  double distance;        ///< distance, never more than the true distance except for rounding [m]
  Eigen::Vector3d point;  ///< point of the body that is nearest to the other shape, in the requested frame
};

/// All points within `radius` of the segment between two points [m].
struct Capsule {
  Eigen::Vector3d from, to;
  double radius;
};

class Solid;

/// A part of a scene: a solid to keep clear of, or a region to stay in.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Returns the distance that the point p_F may move before it meets the shape [m]; negative if the point is in the
  /// forbidden space.
  [[nodiscard]] virtual double pointDistance(const Eigen::Vector3d& p_F) const = 0;

  /// Returns the distance of a body, placed at X_FB, from the shape. The returned point is in frame F.
  [[nodiscard]] virtual Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const = 0;

  /// Returns the distance of a capsule, given in frame F, from the shape.
  [[nodiscard]] virtual Separation separationFrom(const Capsule& body_F) const = 0;

  /// Returns true if the shape is known to be `distance` [m] or more from the capsule. The test is faster than
  /// computing the distance; false means that the distance is unknown.
  [[nodiscard]] virtual bool isFartherThan(double /*distance*/, const Capsule& /*body_F*/) const { return false; }
};

using ShapePointer = std::shared_ptr<const Shape>;

/// A box centred on C's origin, with edges along C's axes.
struct Box {
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half;  ///< half the edge lengths [m]
};

/// A solid described by a core, placed in the solid's frame, and a rounding of constant thickness around the core. The
/// distance library computes distances between cores, which are then reduced by the roundings, so that the cores of
/// rounded solids are well apart even if the solids touch.
struct RoundedCore {
  std::shared_ptr<const fcl::CollisionGeometry<double>> geometry;
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  double rounding = 0;  ///< thickness of the rounding around the core [m]
};

/// A closed convex shape.
class Solid : public Shape {
 public:
  /// Returns the point of the solid farthest along `direction_F` (any length except zero).
  [[nodiscard]] virtual Eigen::Vector3d support(const Eigen::Vector3d& direction_F) const = 0;

  /// Returns the point of the solid farthest from p_F.
  [[nodiscard]] virtual Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p_F) const = 0;

  /// Returns the nearest points of a segment and the solid's core.
  [[nodiscard]] virtual SegmentNearest nearestTo(const Eigen::Vector3d& from_F, const Eigen::Vector3d& to_F) const = 0;

  /// Returns the solid as a box, or null if it is not a box.
  [[nodiscard]] virtual const Box* box() const { return nullptr; }

  [[nodiscard]] Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override;
  [[nodiscard]] Separation separationFrom(const Capsule& body_F) const override;

  /// Returns a capsule around the solid; isCapsule() is true if the solid itself is this capsule.
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
