#include "planner/scene/separation.hpp"

#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Tolerance of the distance library; the default, 1e-6, gives errors of a millimetre between a capsule and a
// metre-sized box.
constexpr double kLibraryTolerance = 1e-12;
// Numerical accuracy of a gap between two bodies [m]; a smaller gap is treated as contact.
constexpr double kContact = 1e-9;
// The library's second solver is called as well if the gap between the supporting planes is smaller than the library's
// distance by more than this [m].
constexpr double kGoodEnough = 1e-9;

double squaredLength(const Vector3d& v) { return v.squaredNorm(); }

struct Proposal {
  double distance;  ///< distance between the cores of the solids [m]
  Vector3d on_a, on_b;
};

/// Returns the nearest points of the cores according to the library; std::nullopt if the library finds contact or
/// fails.
std::optional<Proposal> queryLibrary(const Isometry3d& X_WCa, const RoundedCore& a, const Isometry3d& X_WCb,
                                     const RoundedCore& b, fcl::GJKSolverType solver) {
  const fcl::DistanceRequestd request(true, false, 0.0, 0.0, kLibraryTolerance, solver);
  fcl::DistanceResultd result;
  try {
    fcl::distance(a.geometry.get(), X_WCa, b.geometry.get(), X_WCb, request, result);
  } catch (const std::exception&) {
    return std::nullopt;  // thrown on degenerate, touching configurations
  }
  if (!(result.min_distance > kContact)) return std::nullopt;
  return Proposal{result.min_distance, result.nearest_points[0], result.nearest_points[1]};
}

/// Returns the gap between two planes perpendicular to the line through the proposed points, one supporting a and one
/// supporting b. The gap never exceeds the distance between a and b.
Separation gapAcross(const Proposal& proposal, const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB,
                     const Solid& b) {
  const Vector3d across = (proposal.on_b - proposal.on_a).normalized();
  const Vector3d on_a = X_WA * a.support(X_WA.linear().transpose() * across);
  const Vector3d on_b = X_WB * b.support(X_WB.linear().transpose() * -across);
  return {across.dot(on_b - on_a), proposal.on_a + a.core().rounding * across};
}

Vector3d middle(const Capsule& capsule) { return 0.5 * (capsule.from + capsule.to); }

Proposal between(const Vector3d& on_a, const Vector3d& on_b) { return {(on_b - on_a).norm(), on_a, on_b}; }

Proposal swapped(const Proposal& proposal) { return {proposal.distance, proposal.on_b, proposal.on_a}; }

/// Returns the nearest points of a segment and the core of b, in W.
Proposal fromSegment(const Vector3d& from_W, const Vector3d& to_W, const Isometry3d& X_WB, const Solid& b) {
  const Isometry3d X_BW = X_WB.inverse();
  const auto [on_a, on_b] = b.nearestTo(X_BW * from_W, X_BW * to_W);
  return between(X_WB * on_a, X_WB * on_b);
}

/// Returns the nearest points of a box and the core of b. The box's nearest point is on an edge or within a face;
/// within a face, the nearest point of b is the point that reaches farthest towards the face.
Proposal fromBox(const Isometry3d& X_WA, const Box& a, const Isometry3d& X_WB, const Solid& b) {
  const Isometry3d X_WC = X_WA * a.X_FC, X_CW = X_WC.inverse();
  Proposal best{std::numeric_limits<double>::infinity(), {}, {}};
  const auto offer = [&best](const Proposal& other) {
    if (other.distance < best.distance) best = other;
  };
  for (int k = 0; k < 3; ++k) {
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    for (const auto& [sign1, sign2] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      Vector3d from = a.half;
      from[k1] *= sign1;
      from[k2] *= sign2;
      Vector3d to = from;
      to[k] = -from[k];
      offer(fromSegment(X_WC * from, X_WC * to, X_WB, b));
    }
    for (const double sign : {1.0, -1.0}) {
      const Vector3d normal_B = X_WB.linear().transpose() * (sign * X_WC.linear().col(k));
      const Vector3d on_b_W = X_WB * (b.support(-normal_B) + b.core().rounding * normal_B);
      const Vector3d on_b = X_CW * on_b_W;
      offer(between(X_WC * on_b.cwiseMin(a.half).cwiseMax(-a.half), on_b_W));
    }
  }
  return best;
}

/// Returns the nearest points of the cores if b is a capsule, or a or b is a box; std::nullopt if the library is
/// needed.
std::optional<Proposal> proposalOf(const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB, const Solid& b) {
  if (b.isCapsule()) return swapped(fromSegment(X_WB * b.around().from, X_WB * b.around().to, X_WA, a));
  if (a.box()) return fromBox(X_WA, *a.box(), X_WB, b);
  if (b.box()) return swapped(fromBox(X_WB, *b.box(), X_WA, a));
  return std::nullopt;
}

Separation contact(const Vector3d& point_W, double roundings) { return {-std::max(roundings, kContact), point_W}; }

}  // namespace

// Method: Ericson, Real-Time Collision Detection (2005), section 5.1.9: clamp the parameter of one segment, then of the
// other.
SegmentPair nearestPoints(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d along_a = a1 - a0, along_b = b1 - b0, offset = a0 - b0;
  const double aa = squaredLength(along_a), bb = squaredLength(along_b);
  const double ab = along_a.dot(along_b), ao = along_a.dot(offset), bo = along_b.dot(offset);
  const auto onA = [&](double t) { return aa > 0 ? std::clamp((ab * t - ao) / aa, 0.0, 1.0) : 0.0; };
  const auto onB = [&](double s) { return bb > 0 ? std::clamp((ab * s + bo) / bb, 0.0, 1.0) : 0.0; };
  // The nearest pair includes an end of a segment, or lies on the common perpendicular. All these candidates are
  // compared, because the determinant of nearly parallel segments is nearly zero and too inaccurate to choose one.
  const double determinant = aa * bb - ab * ab;
  const double s_inner = determinant > 0 ? std::clamp((ab * bo - ao * bb) / determinant, 0.0, 1.0) : 0.0;
  const double t_inner = onB(s_inner);
  const std::pair<double, double> candidates[] = {
      {onA(t_inner), t_inner}, {0.0, onB(0.0)}, {1.0, onB(1.0)}, {onA(0.0), 0.0}, {onA(1.0), 1.0}};
  SegmentPair best{a0, b0};
  double best_squared = std::numeric_limits<double>::infinity();
  for (const auto& [s, t] : candidates) {
    const SegmentPair pair{a0 + s * along_a, b0 + t * along_b};
    const double squared = squaredLength(pair.on_a - pair.on_b);
    if (squared < best_squared) best = pair, best_squared = squared;
  }
  return best;
}

Capsule transformed(const Isometry3d& X_WF, const Capsule& capsule_F) {
  return {X_WF * capsule_F.from, X_WF * capsule_F.to, capsule_F.radius};
}

Separation separation(const Capsule& a, const Capsule& b) {
  const auto [on_a, on_b] = nearestPoints(a.from, a.to, b.from, b.to);
  const Vector3d across = on_b - on_a;
  const double distance = across.norm();
  return {distance - a.radius - b.radius, distance > 0 ? Vector3d(on_a + a.radius / distance * across) : on_a};
}

Separation separation(const Capsule& a, const Solid& b) {
  if (b.isCapsule()) return separation(a, b.around());
  const auto [on_a, on_b] = b.nearestTo(a.from, a.to);
  const Vector3d way = on_b - on_a;
  const double distance = way.norm();
  if (!(distance > kContact)) return contact(on_a, a.radius);
  const Vector3d across = way / distance;
  const double reach = std::max(across.dot(a.from), across.dot(a.to));
  return {across.dot(b.support(-across)) - reach - a.radius, on_a + a.radius * across};
}

Separation separation(const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB, const Solid& b) {
  if (a.isCapsule()) {
    const Separation found = separation(transformed(X_WB.inverse() * X_WA, a.around()), b);
    return {found.distance, X_WB * found.point};
  }
  const auto proposal = proposalOf(X_WA, a, X_WB, b);
  if (!proposal) return separationByLibrary(X_WA, a, X_WB, b);
  if (!(proposal->distance > kContact)) return contact(proposal->on_a, a.core().rounding + b.core().rounding);
  return gapAcross(*proposal, X_WA, a, X_WB, b);
}

Separation separationByLibrary(const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB, const Solid& b) {
  const Isometry3d X_WCa = X_WA * a.core().X_FC, X_WCb = X_WB * b.core().X_FC;
  const double roundings = a.core().rounding + b.core().rounding;
  const auto proposal = queryLibrary(X_WCa, a.core(), X_WCb, b.core(), fcl::GST_LIBCCD);
  if (!proposal) return contact(X_WA * middle(a.around()), roundings);
  const Separation proved = gapAcross(*proposal, X_WA, a, X_WB, b);
  if (proved.distance >= proposal->distance - roundings - kGoodEnough) return proved;
  const auto other = queryLibrary(X_WCa, a.core(), X_WCb, b.core(), fcl::GST_INDEP);
  if (!other) return proved;
  const Separation again = gapAcross(*other, X_WA, a, X_WB, b);
  return again.distance > proved.distance ? again : proved;
}

}  // namespace tubeplan::planner
