// Distances of line segments from obstacles and from each other, for several postures side by side. See lanes.hpp for
// the numeric types.
//
// Distances from planes, spheres and other segments have closed forms. Along a segment the squared distance from a box
// or a cylinder is convex. The zero of its slope is found by Newton steps kept within a bracket, as in
// segment_distance.hpp; each lane steps until it converges. The result is the gap between the parallel planes that
// support the segment and the solid, perpendicular to the line through the two points found. This gap never exceeds the
// distance, even if the search has not converged.
#pragma once

#include "deflection/revolute_chain/row_kernel.hpp"
#include "planner/collision/kernels/plain_cell.hpp"

namespace {

using namespace tubeplan::planner::kernels;

constexpr double kContactGap = 1e-9;   // a smaller gap is treated as contact [m]
constexpr double kFinestStep = 1e-15;  // smallest Newton step, as a fraction of the segment's length
constexpr int kMostSteps = 100;

struct Segment {
  Vec from, to;
};

inline Real squared(Vec v) { return dot(v, v); }
inline Real clamped(Real x, Real low, Real high) { return least(greatest(x, low), high); }

/// Returns the squared distance between two segments (Ericson 2005, 5.1.9). The nearest points include an end of a
/// segment, or lie on the common perpendicular; all these candidates are compared.
inline Real squaredDistance(const Segment& a, const Segment& b) {
  const Real zero = constant(0), one = constant(1);
  const Vec along_a = a.to - a.from, along_b = b.to - b.from, offset = a.from - b.from;
  const Real aa = squared(along_a), bb = squared(along_b), ab = dot(along_a, along_b), ao = dot(along_a, offset),
             bo = dot(along_b, offset);
  const Bits has_a = isLess(zero, aa), has_b = isLess(zero, bb);
  const auto onA = [&](Real t) { return select(has_a, clamped((ab * t - ao) / aa, zero, one), zero); };
  const auto onB = [&](Real s) { return select(has_b, clamped((ab * s + bo) / bb, zero, one), zero); };
  const auto at = [&](Real s, Real t) { return squared((offset + s * along_a) - t * along_b); };
  const Real determinant = aa * bb - ab * ab;
  const Real inner = select(isLess(zero, determinant), clamped((ab * bo - ao * bb) / determinant, zero, one), zero);
  const Real t = onB(inner);
  return least(least(least(at(onA(t), t), at(zero, onB(zero))), least(at(one, onB(one)), at(onA(zero), zero))),
               at(onA(one), one));
}

/// Half the slope of the squared distance along a segment, and its derivative.
struct Slope {
  Real slope, curvature;
};

/// Returns the position along the segment, from 0 to 1, where the slope is zero; an end if the slope has one sign
/// throughout. `used_lanes` is the mask of lanes whose result is used.
template <class SlopeAt>
inline Real levelPlace(Bits used_lanes, const SlopeAt& slope_at) {
  const Real zero = constant(0), one = constant(1);
  const Slope start = slope_at(zero), end = slope_at(one);
  const Bits at_start = isAtMost(zero, start.slope), at_end = isAtMost(end.slope, zero);
  Real low = zero, high = one, s = start.slope / (start.slope - end.slope);
  Bits active = used_lanes & ~at_start & ~at_end;
  for (int step = 0; step < kMostSteps && any(active); ++step) {
    const Slope current = slope_at(s);
    active = active & (isLess(current.slope, zero) | isLess(zero, current.slope));
    const Bits rises = isLess(current.slope, zero);
    low = select(active & rises, s, low);
    high = select(active & ~rises, s, high);
    Real next = s - current.slope / current.curvature;
    const Bits inside = isLess(low, next) & isLess(next, high);
    next = select(inside, next, 0.5 * (low + high));
    const Bits is_settled = isAtMost(absolute(next - s), constant(kFinestStep));
    s = select(active, next, s);
    active = active & ~is_settled;
  }
  return select(at_start, zero, select(at_end, one, s));
}

/// Returns the gap between a capsule and a solid along the line through the points found on the capsule's segment and
/// on the solid. `reach` returns the solid's extent from the origin along a unit vector.
template <class Reach>
inline Real gapAcross(const Segment& segment, Vec on_segment, Vec on_solid, Real radius, const Reach& reach) {
  const Vec way = on_solid - on_segment;
  const Real distance = squareRoot(squared(way));
  const Vec across = (1. / distance) * way;
  const Real gap = -reach(across) - greatest(dot(across, segment.from), dot(across, segment.to)) - radius;
  return select(isLess(constant(kContactGap), distance), gap, -greatest(radius, constant(kContactGap)));
}

/// Returns the distance of a capsule from a box with half edge lengths `half`, centred on the origin.
inline Real distanceFromBox(Bits used_lanes, const Segment& segment, Real radius, Vec half) {
  const Real zero = constant(0);
  const Vec along = segment.to - segment.from;
  const auto slopeAt = [&](Real s) {
    const Vec p = segment.from + s * along;
    Slope sum{zero, zero};
    const auto add = [&](Real place, Real way, Real most) {
      const Real beyond = absolute(place) - most;
      const Bits is_out = isLess(zero, beyond);
      sum.slope = sum.slope + select(is_out, way * withSign(beyond, place), zero);
      sum.curvature = sum.curvature + select(is_out, way * way, zero);
    };
    add(p.x, along.x, half.x);
    add(p.y, along.y, half.y);
    add(p.z, along.z, half.z);
    return sum;
  };
  const Vec p = segment.from + levelPlace(used_lanes, slopeAt) * along;
  const Vec on_box{clamped(p.x, -half.x, half.x), clamped(p.y, -half.y, half.y), clamped(p.z, -half.z, half.z)};
  return gapAcross(segment, p, on_box, radius, [&](Vec across) {
    return (absolute(across.x) * half.x + absolute(across.y) * half.y) + absolute(across.z) * half.z;
  });
}

/// Returns the distance of a capsule from a cylinder of radius `thick` and half length `half` [m], along z and centred
/// on the origin.
inline Real distanceFromCylinder(Bits used_lanes, const Segment& segment, Real radius, Real thick, Real half) {
  const Real zero = constant(0);
  const Vec along = segment.to - segment.from;
  const Real level = along.x * along.x + along.y * along.y;
  const auto slopeAt = [&](Real s) {
    const Vec p = segment.from + s * along;
    const Real beyond = absolute(p.z) - half, r = squareRoot(p.x * p.x + p.y * p.y);
    const Bits past_end = isLess(zero, beyond), past_side = isLess(thick, r);
    const Real outwards = (along.x * p.x + along.y * p.y) / r;
    const Real side = outwards * (r - thick), bend = level - thick / r * (level - outwards * outwards);
    return Slope{select(past_end, along.z * withSign(beyond, p.z), zero) + select(past_side, side, zero),
                 select(past_end, along.z * along.z, zero) + select(past_side, bend, zero)};
  };
  const Vec p = segment.from + levelPlace(used_lanes, slopeAt) * along;
  const Real r = squareRoot(p.x * p.x + p.y * p.y), shrink = select(isLess(thick, r), thick / r, constant(1));
  const Vec on_cylinder{shrink * p.x, shrink * p.y, clamped(p.z, -half, half)};
  return gapAcross(segment, p, on_cylinder, radius, [&](Vec across) {
    return thick * squareRoot(across.x * across.x + across.y * across.y) + half * absolute(across.z);
  });
}

/// Returns the squared distance of a point from a box centred on the origin; zero inside the box.
inline Real squaredBeyondBox(Vec p, Vec half) {
  const Real zero = constant(0);
  return squared({greatest(absolute(p.x) - half.x, zero), greatest(absolute(p.y) - half.y, zero),
                  greatest(absolute(p.z) - half.z, zero)});
}

}  // namespace
