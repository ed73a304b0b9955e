// The interface of shapes in a scene: the distance of a body from it. The shapes themselves are in the table,
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

/// Distance between two shapes. It is 0 where they touch and negative where they overlap; only its sign is then
/// meaningful.
struct Separation {
  double distance;        ///< never more than the true distance, beyond rounding [m]
  Eigen::Vector3d point;  ///< point of the body nearest to the other shape, in the requested frame
};

/// All points within `radius` of the segment [m].
struct Capsule {
  Eigen::Vector3d from, to;
  double radius;
};

class Solid;

/// A part of a scene: a solid to keep clear of, or a region to stay in.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Returns how far the point p_F may move before it meets the shape [m]; negative if it is in a forbidden place.
  [[nodiscard]] virtual double pointDistance(const Eigen::Vector3d& p_F) const = 0;

  /// Returns the distance of a body, placed at X_FB, from the shape. The point is in frame F.
  [[nodiscard]] virtual Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const = 0;

  /// Returns the distance of a capsule given in frame F.
  [[nodiscard]] virtual Separation separationFrom(const Capsule& body_F) const = 0;

  /// Returns true if the shape is known to be `distance` [m] or more from the capsule, by a test that is quicker than
  /// the distance.
  [[nodiscard]] virtual bool isFartherThan(double /*distance*/, const Capsule& /*body_F*/) const { return false; }
};

using ShapePointer = std::shared_ptr<const Shape>;

/// A box about C's origin, with edges along C's axes.
struct Box {
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half;  ///< half sizes [m]
};

/// A core for the distance library, placed in the shape's frame, with a rounding around it. Distances are computed
/// between cores and reduced by the roundings, so that touching bodies are still well separated for the library.
struct RoundedCore {
  std::shared_ptr<const fcl::CollisionGeometry<double>> geometry;
  Eigen::Isometry3d X_FC = Eigen::Isometry3d::Identity();
  double rounding = 0;  ///< [m]
};

/// A closed convex body.
class Solid : public Shape {
 public:
  /// Returns the point farthest along `direction_F` (any length but zero).
  [[nodiscard]] virtual Eigen::Vector3d support(const Eigen::Vector3d& direction_F) const = 0;

  /// Returns the point farthest from p_F.
  [[nodiscard]] virtual Eigen::Vector3d farthestFrom(const Eigen::Vector3d& p_F) const = 0;

  /// Returns the nearest points of a segment and the core.
  [[nodiscard]] virtual SegmentNearest nearestTo(const Eigen::Vector3d& from_F, const Eigen::Vector3d& to_F) const = 0;

  /// Returns the solid as a box, or null if it is none.
  [[nodiscard]] virtual const Box* box() const { return nullptr; }

  [[nodiscard]] Separation separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const override;
  [[nodiscard]] Separation separationFrom(const Capsule& body_F) const override;

  /// Returns a capsule around the solid; isCapsule() is true if it is the solid itself.
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
