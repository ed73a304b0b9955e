#include "planner/scene/mesh_shape.hpp"

#include <algorithm>
#include <limits>

#include "planner/scene/separation.hpp"
#include "planner/scene/triangle_distance.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

double leastOfBox(const AlignedBox3d& box, const Vector3d& direction) {
  return direction.dot(box.center()) - 0.5 * direction.cwiseAbs().dot(box.sizes());
}

/// Search for the triangle nearest to a body, in frame F. The plane that separates the body from the nearest triangle
/// found so far rules out most of the triangles that are farther away.
class NearestTriangle {
 public:
  /// The body lies within `radius` [m] of the segment; triangles whose gap to the body is `enough` [m] or more are
  /// ignored.
  NearestTriangle(const Vector3d& from, const Vector3d& to, double radius, double enough)
      : from_(from), to_(to), around_(from.cwiseMin(to), from.cwiseMax(to)), radius_(radius) {
    least.distance = enough;
  }

  /// Searches the triangles, which are in frame F. `gap_to(triangle)` returns the gap between a triangle and the body,
  /// `reach(direction)` the largest coordinate of the body along a direction.
  template <class GapTo, class Reach>
  void search(const TriangleTree& tree, const GapTo& gap_to, const Reach& reach) {
    const auto bound = [&](const AlignedBox3d& box, double enough) {
      const double quick = std::max(around_.exteriorDistance(box) - radius_, leastOfBox(box, least.across) - reach_);
      return quick >= enough ? quick : std::max(quick, gapToBox(box, from_, to_) - radius_);
    };
    const auto look = [&](const Corners& t) {
      if (leastAlong(t, least.across) - reach_ >= least.distance) return;
      const TriangleGap gap = gap_to(t);
      if (!(gap.distance < least.distance)) return;
      least = gap;
      reach_ = reach(gap.across);
    };
    tree.nearestFirst(bound, look, least.distance);
  }

  TriangleGap least{};

 private:
  const Vector3d &from_, &to_;
  AlignedBox3d around_;
  double radius_;
  /// Largest coordinate of the body along `least.across`, the normal of the separating plane.
  double reach_ = std::numeric_limits<double>::infinity();
};

/// Returns the gap between a segment and the triangle nearest to it; the gap is `enough` [m] if no triangle is nearer.
TriangleGap nearestTriangle(const TriangleTree& tree, const Vector3d& from, const Vector3d& to, double enough) {
  NearestTriangle nearest(from, to, 0, enough);
  nearest.search(
      tree, [&](const Corners& t) { return gapTo(t, from, to); },
      [&](const Vector3d& direction) { return std::max(direction.dot(from), direction.dot(to)); });
  return nearest.least;
}

}  // namespace

MeshShape::MeshShape(const TriangleMesh& mesh, const Isometry3d& X_FM) : survey_(surveyMesh(mesh)), tree_(mesh, X_FM) {}

/// Returns true if a point is inside a closed mesh; uncertain cases are treated as inside.
bool MeshShape::isInside(const Vector3d& p) const { return survey_.isClosed() && tree_.windingNumber(p) != 0; }

double MeshShape::pointDistance(const Vector3d& p) const {
  double least = std::numeric_limits<double>::infinity();
  const auto bound = [&](const AlignedBox3d& box, double) { return box.exteriorDistance(p); };
  tree_.nearestFirst(
      bound, [&](const Corners& t) { least = std::min(least, pointGap(t, p)); }, least);
  return isInside(p) ? -least : least;
}

Separation MeshShape::separationFrom(const Capsule& body) const {
  const TriangleGap least = nearestTriangle(tree_, body.from, body.to, std::numeric_limits<double>::infinity());
  if (!(least.distance > kTriangleContact) || isInside(body.from))
    return {-std::max(body.radius, kTriangleContact), least.point};
  return {least.distance - body.radius, least.point + body.radius * least.across};
}

Separation MeshShape::separationFrom(const Isometry3d& X_FB, const Solid& body) const {
  if (body.isCapsule()) return separationFrom(transformed(X_FB, body.around()));
  const Capsule around = transformed(X_FB, body.around());
  const Isometry3d X_BF = X_FB.inverse();
  const double rounding = body.core().rounding;
  NearestTriangle nearest(around.from, around.to, around.radius, std::numeric_limits<double>::infinity());
  const auto gap_to = [&](const Corners& t) {
    const TriangleGap gap = gapTo({X_BF * t[0], X_BF * t[1], X_BF * t[2]}, body);
    return TriangleGap{gap.distance, X_FB * gap.point, X_FB.linear() * gap.across};
  };
  const auto reach = [&](const Vector3d& direction) {
    if (direction.isZero(0)) return 0.0;
    return direction.dot(X_FB * body.support(X_BF.linear() * direction)) - rounding;
  };
  nearest.search(tree_, gap_to, reach);
  const TriangleGap& least = nearest.least;
  if (!(least.distance > kTriangleContact) || isInside(X_FB * body.support(Vector3d::UnitX())))
    return {-std::max(rounding, kTriangleContact), least.point};
  return {least.distance - rounding, least.point + rounding * least.across};
}

bool MeshShape::isFartherThan(double distance, const Capsule& body) const {
  const double enough = distance + body.radius;
  return nearestTriangle(tree_, body.from, body.to, enough).distance >= enough && !isInside(body.from);
}

}  // namespace tubeplan::planner
