#include "planner/scene/triangle_distance.hpp"

#include <algorithm>
#include <cmath>

#include "planner/scene/separation.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;

// Sine of the angle between two edges below which the normal of the triangle is not well defined.
constexpr double kThinnest = 1e-10;

/// Returns the unit normal of a triangle; zero if the triangle is a line or a point.
Vector3d normalOf(const Corners& t) {
  const Vector3d ab = t[1] - t[0], ac = t[2] - t[0], normal = ab.cross(ac);
  const double length = normal.norm();
  if (!(length > kThinnest * ab.norm() * ac.norm())) return Vector3d::Zero();
  return normal / length;
}

/// Returns true if the perpendicular projection of p onto the triangle's plane lies within the triangle.
bool isOver(const Corners& t, const Vector3d& normal, const Vector3d& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (normal.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) < 0) return false;
  return true;
}

struct Segment {
  const Vector3d &from, &to;
  [[nodiscard]] SegmentNearest nearestTo(const Vector3d& a, const Vector3d& b) const {
    const auto [on_a, on_own] = nearestPoints(a, b, from, to);
    return {on_a, on_own};
  }
  [[nodiscard]] const Vector3d& support(const Vector3d& direction) const {
    return direction.dot(to - from) > 0 ? to : from;
  }
};

/// A solid without its rounding, which the caller subtracts from the gap.
struct Core {
  const Solid& solid;
  [[nodiscard]] SegmentNearest nearestTo(const Vector3d& a, const Vector3d& b) const { return solid.nearestTo(a, b); }
  [[nodiscard]] Vector3d support(const Vector3d& direction) const {
    const Vector3d farthest = solid.support(direction);
    return solid.core().rounding > 0 ? Vector3d(farthest - solid.core().rounding * direction.normalized()) : farthest;
  }
};

/// Returns the gap between a convex body and a triangle. Either the triangle's nearest point is on an edge, or the
/// body's nearest point is the point that reaches farthest towards the face. A body that intersects the triangle but
/// none of its edges passes through the face.
template <class Body>
TriangleGap gapBetween(const Corners& t, const Body& body) {
  TriangleGap best{-std::numeric_limits<double>::infinity(), {}};
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vector3d& across, const Vector3d& on_body, double length) {
    best.distance = std::max(best.distance, leastAlong(t, across) - across.dot(body.support(across)));
    if (length < nearest) nearest = length, best.point = on_body, best.across = across;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [on_edge, on_body] = body.nearestTo(t[k], t[(k + 1) % 3]);
    const Vector3d across = on_edge - on_body;
    const double length = across.norm();
    if (!(length > kTriangleContact)) return {0, on_body};
    offer(across / length, on_body, length);
  }
  const Vector3d normal = normalOf(t);
  if (normal.isZero(0)) return best;
  const Vector3d lowest = body.support(-normal), highest = body.support(normal);
  const double low = normal.dot(lowest - t[0]), high = normal.dot(highest - t[0]);
  if (low > 0) {
    if (isOver(t, normal, lowest)) offer(-normal, lowest, low);
  } else if (high < 0) {
    if (isOver(t, normal, highest)) offer(normal, highest, -high);
  } else {
    const Vector3d within = high > low ? Vector3d(lowest - low / (high - low) * (highest - lowest)) : lowest;
    if (isOver(t, normal, within)) return {0, within};
  }
  return best;
}

}  // namespace

TriangleGap gapTo(const Corners& triangle, const Vector3d& from, const Vector3d& to) {
  return gapBetween(triangle, Segment{from, to});
}

TriangleGap gapTo(const Corners& triangle, const Solid& solid) { return gapBetween(triangle, Core{solid}); }

double pointGap(const Corners& t, const Vector3d& p) {
  double best = 0;
  const auto offer = [&](const Vector3d& away) {
    const double length = away.norm();
    if (length > 0)
      best = std::max(best, (away.dot(p) - std::max({away.dot(t[0]), away.dot(t[1]), away.dot(t[2])})) / length);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d along = t[(k + 1) % 3] - t[k], off = p - t[k];
    const double squared = along.squaredNorm();
    offer(off - (squared > 0 ? std::clamp(off.dot(along) / squared, 0.0, 1.0) : 0.0) * along);
  }
  const Vector3d normal = normalOf(t);
  if (isOver(t, normal, p)) offer(normal.dot(p - t[0]) < 0 ? -normal : normal);
  return best;
}

double gapToBox(const Eigen::AlignedBox3d& box, const Vector3d& from, const Vector3d& to) {
  const Vector3d middle = box.center(), half = 0.5 * box.sizes();
  const auto [on_segment, on_box] = nearestToBox(from - middle, to - middle, half);
  const Vector3d across = on_segment - on_box;
  const double length = across.norm();
  if (!(length > 0)) return 0;
  const double least = std::min(across.dot(from - middle), across.dot(to - middle));
  return std::max(0.0, (least - across.cwiseAbs().dot(half)) / length);
}

}  // namespace tubeplan::planner
