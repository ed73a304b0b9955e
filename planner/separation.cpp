#include "planner/separation.hpp"

#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The library's default, 1e-6, errs by a millimetre between a capsule and a metre-sized box.
constexpr double kLibraryTolerance = 1e-12;
// Below this the library cannot tell a gap from contact; it counts as contact.
constexpr double kContact = 1e-9;
// How much the proved gap may fall short of the library's distance before the library's other solver is asked as well.
constexpr double kGoodEnough = 1e-9;

double squaredLength(const Vector3d& v) { return v.squaredNorm(); }

struct Proposal {
  double distance;  ///< between the cores
  Vector3d on_a, on_b;
};

/// The library's opinion on the cores; none where it takes them to touch, or gives up on them.
std::optional<Proposal> askLibrary(const Isometry3d& X_WCa, const RoundedCore& a, const Isometry3d& X_WCb,
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

/// The gap between the planes that support a and b across the proposed direction: never more than their distance.
Separation gapAcross(const Proposal& proposal, const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB,
                     const Solid& b) {
  const Vector3d across = (proposal.on_b - proposal.on_a).normalized();
  const Vector3d on_a = X_WA * a.support(X_WA.linear().transpose() * across);
  const Vector3d on_b = X_WB * b.support(X_WB.linear().transpose() * -across);
  return {across.dot(on_b - on_a), proposal.on_a + a.core().rounding * across};
}

Vector3d middle(const Capsule& capsule) { return 0.5 * (capsule.from + capsule.to); }

}  // namespace

// Ericson, Real-Time Collision Detection (2005), section 5.1.9: clamp one parameter, then the other.
SegmentPair nearestPoints(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d along_a = a1 - a0, along_b = b1 - b0, offset = a0 - b0;
  const double aa = squaredLength(along_a), bb = squaredLength(along_b);
  const double ab = along_a.dot(along_b), ao = along_a.dot(offset), bo = along_b.dot(offset);
  const auto onA = [&](double t) { return aa > 0 ? std::clamp((ab * t - ao) / aa, 0.0, 1.0) : 0.0; };
  const auto onB = [&](double s) { return bb > 0 ? std::clamp((ab * s + bo) / bb, 0.0, 1.0) : 0.0; };
  // The nearest pair has an end of one segment, or is where the common perpendicular stands. Trying all of these,
  // rather than deciding by the nearly-zero determinant of nearly parallel segments, keeps every digit.
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

Separation separation(const Isometry3d& X_WA, const Solid& a, const Isometry3d& X_WB, const Solid& b) {
  if (a.isCapsule() && b.isCapsule()) return separation(transformed(X_WA, a.around()), transformed(X_WB, b.around()));
  const Isometry3d X_WCa = X_WA * a.core().X_FC, X_WCb = X_WB * b.core().X_FC;
  const double roundings = a.core().rounding + b.core().rounding;
  const auto proposal = askLibrary(X_WCa, a.core(), X_WCb, b.core(), fcl::GST_LIBCCD);
  if (!proposal) return {-std::max(roundings, kContact), X_WA * middle(a.around())};
  const Separation proved = gapAcross(*proposal, X_WA, a, X_WB, b);
  if (proved.distance >= proposal->distance - roundings - kGoodEnough) return proved;
  const auto other = askLibrary(X_WCa, a.core(), X_WCb, b.core(), fcl::GST_INDEP);
  if (!other) return proved;
  const Separation again = gapAcross(*other, X_WA, a, X_WB, b);
  return again.distance > proved.distance ? again : proved;
}

}  // namespace tubeplan::planner
