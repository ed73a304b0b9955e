#include "planner/collision/nearest_pairs.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "deflection/revolute_chain/plain_pose.hpp"
#include "planner/scene/mesh_shape.hpp"
#include "planner/scene/regions.hpp"
#include "planner/scene/separation.hpp"
#include "planner/scene/solids.hpp"

namespace tubeplan::planner {

using deflection::simd::copy, deflection::simd::plainPose;
using Eigen::Isometry3d, Eigen::Vector3d;
using kernels::PairKind, kernels::PlainObstacle;

namespace {

double halfLengthOf(const Capsule& capsule) { return 0.5 * (capsule.to - capsule.from).norm(); }

struct KnownObstacle {
  PairKind kind;
  bool is_itself;  ///< false if a bounding solid replaces the obstacle
};

KnownObstacle boxOf(const Isometry3d& X_WC, const Vector3d& half, bool is_itself, PlainObstacle& plain) {
  copy(half, plain.half);
  plain.X_CW = plainPose(X_WC.inverse());
  return {PairKind::kBox, is_itself};
}

KnownObstacle capsuleOf(const Capsule& capsule, bool is_itself, PlainObstacle& plain) {
  copy(capsule.from, plain.from);
  copy(capsule.to, plain.to);
  plain.radius = capsule.radius;
  plain.half_length = halfLengthOf(capsule);
  return {PairKind::kFixedCapsule, is_itself};
}

KnownObstacle meshOf(const MeshShape& mesh, PlainObstacle& plain) {
  const Eigen::AlignedBox3d& bounds = mesh.tree().bounds();
  return boxOf(Isometry3d(Eigen::Translation3d(bounds.center())), 0.5 * bounds.sizes() * (1 + 1e-12), false, plain);
}

KnownObstacle cylinderOf(const CylinderSolid& cylinder, PlainObstacle& plain) {
  plain.radius = cylinder.radius();
  plain.half_length = cylinder.halfLength();
  plain.X_CW = plainPose(cylinder.core().X_FC.inverse());
  return {PairKind::kCylinder, true};
}

/// Replaces a shape that the kernels do not support with a sphere of infinite radius, so that its pairs are never
/// skipped.
KnownObstacle unknown(PlainObstacle& plain) {
  return capsuleOf({Vector3d::Zero(), Vector3d::Zero(), std::numeric_limits<double>::infinity()}, false, plain);
}

KnownObstacle plainOf(const Shape& shape, PlainObstacle& plain) {
  if (const auto* plane = dynamic_cast<const HalfSpace*>(&shape)) {
    copy(plane->point(), plain.from);
    copy(plane->normal(), plain.normal);
    return {PairKind::kPlane, true};
  }
  if (const auto* sphere = dynamic_cast<const SphereInterior*>(&shape)) {
    copy(sphere->centre(), plain.from);
    plain.radius = sphere->radius();
    return {PairKind::kSphereInside, true};
  }
  if (const auto* mesh = dynamic_cast<const MeshShape*>(&shape)) return meshOf(*mesh, plain);
  if (const auto* cylinder = dynamic_cast<const CylinderSolid*>(&shape)) return cylinderOf(*cylinder, plain);
  const auto* solid = dynamic_cast<const Solid*>(&shape);
  if (!solid) return unknown(plain);
  if (const Box* box = solid->box()) return boxOf(box->X_FC, box->half, true, plain);
  return capsuleOf(solid->around(), solid->isCapsule(), plain);
}

/// Returns the rank of a pair's cost. Cheap pairs come first, because their results rule out most of the expensive
/// pairs.
int costOf(PairKind kind) { return kind == PairKind::kBox || kind == PairKind::kCylinder ? 1 : 0; }

}  // namespace

NearestPairs::NearestPairs(Scene scene) : scene_(std::move(scene)) {
  assert(findSceneProblems(scene_).empty());
  for (const Body& body : scene_.bodies) {
    solids_.push_back(dynamic_cast<const Solid*>(body.shape.get()));
    const Capsule& around = solids_.back()->around();
    kernels::PlainBody plain{body.frame_index, {}, {}, around.radius, halfLengthOf(around)};
    copy(around.from, plain.from);
    copy(around.to, plain.to);
    bodies_.push_back(plain);
  }
  for (const Obstacle& obstacle : scene_.obstacles) {
    obstacles_.push_back({});
    const KnownObstacle known = plainOf(*obstacle.shape, obstacles_.back());
    obstacle_kinds_.push_back(known.kind);
    obstacle_is_plain_.push_back(known.is_itself);
  }
  addPairs();
}

void NearestPairs::addPairs() {
  std::vector<kernels::PlainPair> exact, bounded;
  const auto add = [&](PairKind kind, int body, int other, bool is_exact) {
    (is_exact ? exact : bounded).push_back({kind, body, other});
  };
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    const auto body = static_cast<std::size_t>(i);
    const bool is_capsule = solids_[body]->isCapsule();
    for (int k = 0; k < static_cast<int>(obstacles_.size()); ++k) {
      const auto other = static_cast<std::size_t>(k);
      if (!mayTouch(scene_.obstacles[other], scene_.bodies[body]))
        add(obstacle_kinds_[other], i, k, is_capsule && obstacle_is_plain_[other]);
    }
    for (int k = 0; k < i; ++k) {
      const auto other = static_cast<std::size_t>(k);
      if (areJudged(scene_, k, i) && !mayTouch(scene_.bodies[other], scene_.bodies[body]))
        add(PairKind::kBodyAndBody, i, k, is_capsule && solids_[other]->isCapsule());
    }
  }
  std::ranges::stable_sort(exact, {}, [](const auto& pair) { return costOf(pair.kind); });
  exact_ = static_cast<int>(exact.size());
  pairs_ = std::move(exact);
  pairs_.insert(pairs_.end(), bounded.begin(), bounded.end());
}

Capsule NearestPairs::around(const deflection::PlacedRows& placed, int lane, int body) const {
  const auto index = static_cast<std::size_t>(body);
  return transformed(placed.X_WL(bodies_[index].row, lane), solids_[index]->around());
}

Separation NearestPairs::separationOf(const deflection::PlacedRows& placed, int lane,
                                      const kernels::PlainPair& pair) const {
  const auto body = static_cast<std::size_t>(pair.body), other = static_cast<std::size_t>(pair.other);
  const Isometry3d X_WB = placed.X_WL(bodies_[body].row, lane);
  if (pair.kind == PairKind::kBodyAndBody) {
    if (solids_[body]->isCapsule() && solids_[other]->isCapsule())
      return separation(around(placed, lane, pair.body), around(placed, lane, pair.other));
    return separation(X_WB, *solids_[body], placed.X_WL(bodies_[other].row, lane), *solids_[other]);
  }
  const Shape& obstacle = *scene_.obstacles[other].shape;
  return solids_[body]->isCapsule() ? obstacle.separationFrom(around(placed, lane, pair.body))
                                    : obstacle.separationFrom(X_WB, *solids_[body]);
}

/// Returns true if the obstacle of a pair is known to be farther than `distance` [m] from the body. Some shapes, such
/// as meshes, have a better bound than the kernel's.
bool NearestPairs::isFarther(const deflection::PlacedRows& placed, int lane, const kernels::PlainPair& pair,
                             double distance) const {
  if (pair.kind == PairKind::kBodyAndBody) return false;
  return scene_.obstacles[static_cast<std::size_t>(pair.other)].shape->isFartherThan(distance,
                                                                                     around(placed, lane, pair.body));
}

void NearestPairs::find(const deflection::PlacedRows& placed, std::span<NearestPair> found) const {
  constexpr std::size_t kLanes = kernels::kMostLanes;
  assert(found.size() >= static_cast<std::size_t>(placed.count));
  const int width = placed.lanes;
  std::array<double, kLanes> distance, nearest;
  std::vector<double> ends(6 * bodies_.size() * static_cast<std::size_t>(width)),
      bounds((pairs_.size() - static_cast<std::size_t>(exact_)) * static_cast<std::size_t>(width));
  const kernels::PlainScene scene{bodies_.data(), obstacles_.data(),
                                  pairs_.data(),  static_cast<int>(bodies_.size()),
                                  exact_,         static_cast<int>(pairs_.size())};
  kernels::kernelOf(width).nearest(scene, placed.frames.data(),
                                   {ends.data(), distance.data(), nearest.data(), bounds.data(), width});
  const auto isLost = [&](int lane) {
    for (std::size_t k = 0; k < 6 * bodies_.size(); ++k)
      if (!std::isfinite(ends[k * static_cast<std::size_t>(width) + static_cast<std::size_t>(lane)])) return true;
    return false;
  };
  for (int lane = 0; lane < placed.count; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    found[l] = {};
    if (!placed.is_converged[l] || isLost(lane)) continue;
    found[l] = {distance[l], static_cast<int>(nearest[l])};
    for (std::size_t k = static_cast<std::size_t>(exact_); k < pairs_.size(); ++k) {
      const double bound = bounds[(k - static_cast<std::size_t>(exact_)) * static_cast<std::size_t>(width) + l];
      if (bound >= found[l].distance || isFarther(placed, lane, pairs_[k], found[l].distance)) continue;
      const double exact_distance = separationOf(placed, lane, pairs_[k]).distance;
      if (exact_distance < found[l].distance) found[l] = {exact_distance, static_cast<int>(k)};
    }
  }
}

NearestPair NearestPairs::findPadded(const deflection::PlacedRows& placed, int lane, const BasePadding& padding) const {
  NearestPair found;
  if (!placed.is_converged[static_cast<std::size_t>(lane)]) return found;
  for (const auto& body : bodies_)
    if (!placed.X_WL(body.row, lane).matrix().allFinite()) return found;
  found.distance = std::numeric_limits<double>::infinity();
  std::vector<double> padded(scene_.bodies.size(), -1);  // padding of each body in any direction; -1 until computed
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const kernels::PlainPair& pair = pairs_[k];
    double away = 0;
    if (pair.kind != PairKind::kBodyAndBody) {
      const auto other = static_cast<std::size_t>(pair.other), body = static_cast<std::size_t>(pair.body);
      const Capsule around_W = around(placed, lane, pair.body);
      const Shape& obstacle = *scene_.obstacles[other].shape;
      const int row = scene_.bodies[body].frame_index;
      if (pair.kind == PairKind::kPlane) {
        away = padding.towards(obstacle, around_W, row);
      } else {
        if (padded[body] < 0) padded[body] = padding.of(around_W, row);
        away = padded[body];
      }
      if (isFarther(placed, lane, pair, found.distance + away)) continue;
    }
    const double distance = separationOf(placed, lane, pair).distance - away;
    if (distance < found.distance) found = {distance, static_cast<int>(k)};
  }
  return found;
}

Clearance NearestPairs::named(const deflection::PlacedRows& placed, int lane, const NearestPair& found) const {
  Clearance clearance;
  if (!placed.is_converged[static_cast<std::size_t>(lane)]) {
    clearance.other = "the deflected shape does not converge";
    return clearance;
  }
  clearance.distance = found.distance;
  clearance.margin = found.distance - scene_.clearance;
  if (std::isnan(found.distance)) {
    for (const Body& body : scene_.bodies)
      if (!placed.X_WL(body.frame_index, lane).matrix().allFinite()) clearance.body = bodyLabel(body);
    clearance.other = "its pose is not a number";
    return clearance;
  }
  if (found.pair < 0) return clearance;
  const kernels::PlainPair& pair = pairs_[static_cast<std::size_t>(found.pair)];
  const auto other = static_cast<std::size_t>(pair.other);
  clearance.body = bodyLabel(scene_.bodies[static_cast<std::size_t>(pair.body)]);
  clearance.other =
      pair.kind == PairKind::kBodyAndBody ? bodyLabel(scene_.bodies[other]) : scene_.obstacles[other].name;
  clearance.point_W = separationOf(placed, lane, pair).point;
  return clearance;
}

}  // namespace tubeplan::planner
