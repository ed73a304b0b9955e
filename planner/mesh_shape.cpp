#include "planner/mesh_shape.hpp"

#include <algorithm>
#include <limits>

#include "planner/separation.hpp"
#include "planner/triangle_distance.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// The search's lower bound of a box: quickly where the boxes about both are far enough apart, else properly.
auto boundFrom(const Vector3d& from, const Vector3d& to, double radius) {
  const AlignedBox3d around(from.cwiseMin(to), from.cwiseMax(to));
  return [=](const AlignedBox3d& box, double least) {
    const double quick = around.exteriorDistance(box) - radius;
    return quick >= least ? quick : std::max(quick, gapToBox(box, from, to) - radius);
  };
}

}  // namespace

MeshShape::MeshShape(const TriangleMesh& mesh, const Isometry3d& X_FM) : survey_(surveyMesh(mesh)), tree_(mesh, X_FM) {}

/// What cannot be told counts as inside.
bool MeshShape::isInside(const Vector3d& p) const { return survey_.isClosed() && tree_.windingNumber(p) != 0; }

double MeshShape::pointDistance(const Vector3d& p) const {
  double least = std::numeric_limits<double>::infinity();
  const auto bound = [&](const AlignedBox3d& box, double) { return box.exteriorDistance(p); };
  tree_.nearestFirst(
      bound, [&](const Corners& t) { least = std::min(least, pointGap(t, p)); }, least);
  return isInside(p) ? -least : least;
}

Separation MeshShape::separationFrom(const Capsule& body) const {
  TriangleGap least{std::numeric_limits<double>::infinity(), body.from};
  const auto look = [&](const Corners& t) {
    const TriangleGap gap = gapTo(t, body.from, body.to);
    if (gap.distance < least.distance) least = gap;
  };
  tree_.nearestFirst(boundFrom(body.from, body.to, 0), look, least.distance);
  if (!(least.distance > kTriangleContact) || isInside(body.from))
    return {-std::max(body.radius, kTriangleContact), least.point};
  return {least.distance - body.radius, least.point + body.radius * least.across};
}

Separation MeshShape::separationFrom(const Isometry3d& X_FB, const Solid& body) const {
  if (body.isCapsule()) return separationFrom(transformed(X_FB, body.around()));
  const Capsule around = transformed(X_FB, body.around());
  const Isometry3d X_BF = X_FB.inverse();
  TriangleGap least{std::numeric_limits<double>::infinity(), body.around().from};
  const auto look = [&](const Corners& t) {
    const TriangleGap gap = gapTo({X_BF * t[0], X_BF * t[1], X_BF * t[2]}, body);
    if (gap.distance < least.distance) least = gap;
  };
  tree_.nearestFirst(boundFrom(around.from, around.to, around.radius), look, least.distance);
  const double rounding = body.core().rounding;
  if (!(least.distance > kTriangleContact) || isInside(X_FB * body.support(Vector3d::UnitX())))
    return {-std::max(rounding, kTriangleContact), X_FB * least.point};
  return {least.distance - rounding, X_FB * (least.point + rounding * least.across)};
}

bool MeshShape::isFartherThan(double distance, const Capsule& body) const {
  double least = distance + body.radius;
  const auto look = [&](const Corners& t) { least = std::min(least, gapTo(t, body.from, body.to).distance); };
  tree_.nearestFirst(boundFrom(body.from, body.to, 0), look, least);
  return least >= distance + body.radius && !isInside(body.from);
}

}  // namespace tubeplan::planner
