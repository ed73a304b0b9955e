// Nearest pair in each of several postures, computed side by side. See plain_cell.hpp for the input.
//
// Pairs are computed one after the other, each for all postures at once. Before an iterative search, or the distance
// between two segments, the sphere around the capsule shows whether the pair can be nearer than the nearest pair so
// far. If it cannot, the lane is left unchanged even if other lanes continue. The result of a posture is therefore
// bit-identical regardless of the other lanes.
#pragma once

#include "planner/collision/kernels/distance_kernel.hpp"

namespace {

constexpr double kInfinity = __builtin_inf();

/// Returns true in the lanes where two bodies can be nearer than `limit`. `squared_distance`: squared distance of their
/// centres; `reach`: sum of the bodies' extents about their centres.
inline Bits mayBeNearer(Real squared_distance, Real limit, double reach) {
  const Real most = limit + reach;
  return isLess(constant(0), most) & ~isLess(most * most, squared_distance);
}

inline Vec middleOf(const Segment& segment) { return constant(0.5) * (segment.from + segment.to); }

inline Vec inFrame(const PlainPose& X_CW, Vec p) { return same(X_CW.p) + turnedBy(X_CW, p); }

struct Found {
  Real distance;
  Bits may_be_near;  ///< lanes where the distance may be smaller than the limit
};

inline Found capsuleDistance(const Segment& a, const PlainBody& body, const Segment& b, double radius,
                             double half_length, Real limit) {
  const Real radii = constant(body.radius) + constant(radius);
  const double reach = body.radius + radius + body.half_length + half_length;
  const Bits may_be_near = mayBeNearer(squared(middleOf(a) - middleOf(b)), limit, reach);
  if (!any(may_be_near)) return {constant(kInfinity), may_be_near};
  return {squareRoot(squaredDistance(a, b)) - radii, may_be_near};
}

inline Found fromPlane(const Segment& a, const PlainBody& body, const PlainObstacle& plane, Real limit) {
  const Vec normal = same(plane.normal), point = same(plane.from);
  const Real distance = least(dot(normal, a.from - point), dot(normal, a.to - point)) - body.radius;
  return {distance, isLess(distance, limit)};
}

inline Found withinSphere(const Segment& a, const PlainBody& body, const PlainObstacle& sphere, Real limit) {
  const Vec centre = same(sphere.from);
  const Real farthest = greatest(squared(a.from - centre), squared(a.to - centre));
  const Real distance = (sphere.radius - squareRoot(farthest)) - body.radius;
  return {distance, isLess(distance, limit)};
}

inline Found fromSearched(const Segment& a_W, const PlainBody& body, const PlainObstacle& solid, bool is_box,
                          Real limit) {
  const Segment a{inFrame(solid.X_CW, a_W.from), inFrame(solid.X_CW, a_W.to)};
  const Real thick = constant(solid.radius), half_length = constant(solid.half_length);
  const Vec half = is_box ? same(solid.half) : Vec{thick, thick, half_length};
  const Bits may_be_near = mayBeNearer(squaredBeyondBox(middleOf(a), half), limit, body.radius + body.half_length);
  if (!any(may_be_near)) return {constant(kInfinity), may_be_near};
  const Real radius = constant(body.radius);
  return {is_box ? distanceFromBox(may_be_near, a, radius, half)
                 : distanceFromCylinder(may_be_near, a, radius, thick, half_length),
          may_be_near};
}

inline Segment axisOf(const FoundPairs& out, int body) {
  const double* from = out.ends + 6 * body * out.stride;
  return {loadVec(from, out.stride), loadVec(from + 3 * out.stride, out.stride)};
}

inline Found look(const PlainScene& scene, const PlainPair& pair, const FoundPairs& out, Real limit) {
  const PlainBody& body = scene.bodies[pair.body];
  const Segment a = axisOf(out, pair.body);
  if (pair.kind == kBodyAndBody) {
    const PlainBody& other = scene.bodies[pair.other];
    return capsuleDistance(a, body, axisOf(out, pair.other), other.radius, other.half_length, limit);
  }
  const PlainObstacle& other = scene.obstacles[pair.other];
  switch (pair.kind) {
    case kPlane:
      return fromPlane(a, body, other, limit);
    case kSphereInside:
      return withinSphere(a, body, other, limit);
    case kFixedCapsule:
      return capsuleDistance(a, body, {same(other.from), same(other.to)}, other.radius, other.half_length, limit);
    default:
      return fromSearched(a, body, other, pair.kind == kBox, limit);
  }
}

/// Finds the nearest pair of each lane's posture. `frames` has the layout of PlacedRows and the stride of `out`.
inline void findNearest(const PlainScene& scene, const double* frames, const FoundPairs& out) {
  for (int i = 0; i < scene.body_count; ++i) {
    const PlainBody& body = scene.bodies[i];
    const RowFrame X = loadFrame(frames + 12 * body.row * out.stride, out.stride);
    storeLanes(out.ends + 6 * i * out.stride, out.stride, placed(X, body.from));
    storeLanes(out.ends + (6 * i + 3) * out.stride, out.stride, placed(X, body.to));
  }
  Real distance = constant(kInfinity), nearest = constant(-1);
  for (int k = 0; k < scene.exact_count; ++k) {
    const Found found = look(scene, scene.pairs[k], out, distance);
    const Bits nearer = found.may_be_near & isLess(found.distance, distance);
    distance = select(nearer, found.distance, distance);
    nearest = select(nearer, constant(k), nearest);
  }
  store(out.distance, distance);
  store(out.nearest, nearest);
  for (int k = scene.exact_count; k < scene.pair_count; ++k) {
    const Found bound = look(scene, scene.pairs[k], out, distance);
    store(out.bounds + (k - scene.exact_count) * out.stride,
          select(bound.may_be_near, bound.distance, constant(kInfinity)));
  }
}

}  // namespace
