#include "planner/collision/clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

using Eigen::Isometry3d;
using Eigen::Vector3d;

struct CollisionWorld::Placed {
  std::span<const Isometry3d> X_WL;
  std::vector<Capsule> around_W;  ///< one per body
};

std::string describe(const Clearance& clearance) {
  if (clearance.body.empty() && clearance.other.empty())
    return std::isfinite(clearance.margin)
               ? fmt::format("the arm clears everything by {:.4g} m more than required", clearance.margin)
               : "nothing is near the arm";
  if (std::isnan(clearance.distance))
    return clearance.body.empty() ? clearance.other : fmt::format("{}: {}", clearance.body, clearance.other);
  const double required = clearance.distance - clearance.margin;
  if (clearance.distance < 0) return fmt::format("{} collides with {}", clearance.body, clearance.other);
  return fmt::format("{} is {:.4f} m from {}, {:.4f} m required", clearance.body, clearance.distance, clearance.other,
                     required);
}

CollisionWorld::CollisionWorld(Scene scene) : scene_(std::move(scene)), body_reach_(scene_.links.size(), 0.0) {
  assert(findSceneProblems(scene_).empty());
  for (const Body& body : scene_.bodies) {
    solids_.push_back(dynamic_cast<const Solid*>(body.shape.get()));
    double& reach = body_reach_[body.frame_index];
    reach = std::max(reach, solids_.back()->farthestFrom(Vector3d::Zero()).norm());
  }
  for (int i = 0; i < static_cast<int>(scene_.bodies.size()); ++i) {
    for (int k = 0; k < static_cast<int>(scene_.obstacles.size()); ++k) {
      const Obstacle& obstacle = scene_.obstacles[k];
      addPair({i, k, false, dynamic_cast<const Solid*>(obstacle.shape.get())}, mayTouch(obstacle, scene_.bodies[i]));
    }
    for (int k = 0; k < i; ++k)
      if (areJudged(scene_, k, i)) addPair({i, k, true, solids_[k]}, mayTouch(scene_.bodies[k], scene_.bodies[i]));
  }
  // Pairs in closed form first: they cost little, and what they find spares most of the others.
  std::ranges::stable_partition(pairs_, [this](const Pair& pair) { return isQuick(pair); });
}

void CollisionWorld::addPair(const Pair& pair, bool allowed) { (allowed ? allowed_pairs_ : pairs_).push_back(pair); }

bool CollisionWorld::isQuick(const Pair& pair) const {
  if (pair.solid) return pair.solid->isCapsule() && solids_[pair.body]->isCapsule();
  return !scene_.obstacles[pair.other].shape->isSearched();
}

CollisionWorld::Placed CollisionWorld::place(std::span<const Isometry3d> X_WL) const {
  assert(X_WL.size() == scene_.links.size());
  Placed placed{X_WL, {}};
  placed.around_W.reserve(solids_.size());
  for (std::size_t i = 0; i < solids_.size(); ++i)
    placed.around_W.push_back(transformed(X_WL[scene_.bodies[i].frame_index], solids_[i]->around()));
  return placed;
}

/// By the spheres around the capsules around the two, then by the capsules; what is no solid is asked itself.
bool CollisionWorld::isFarther(const Pair& pair, const Placed& placed, double distance) const {
  const Capsule& a = placed.around_W[pair.body];
  if (!pair.solid) return scene_.obstacles[pair.other].shape->isFartherThan(distance, a);
  const Capsule& b = pair.with_body ? placed.around_W[pair.other] : pair.solid->around();
  const double reach = distance + a.radius + b.radius +
                       0.5 * (std::sqrt((a.to - a.from).squaredNorm()) + std::sqrt((b.to - b.from).squaredNorm()));
  if (reach < 0 || 0.25 * (a.from + a.to - b.from - b.to).squaredNorm() > reach * reach) return true;
  return separation(a, b).distance >= distance;
}

Separation CollisionWorld::pairSeparation(const Pair& pair, const Placed& placed) const {
  const Isometry3d& X_WB = placed.X_WL[scene_.bodies[pair.body].frame_index];
  const bool is_capsule = solids_[pair.body]->isCapsule();
  if (!pair.with_body) {
    const Shape& obstacle = *scene_.obstacles[pair.other].shape;
    return is_capsule ? obstacle.separationFrom(placed.around_W[pair.body])
                      : obstacle.separationFrom(X_WB, *solids_[pair.body]);
  }
  if (is_capsule && pair.solid->isCapsule()) return separation(placed.around_W[pair.body], placed.around_W[pair.other]);
  return separation(X_WB, *solids_[pair.body], placed.X_WL[scene_.bodies[pair.other].frame_index], *pair.solid);
}

Clearance CollisionWorld::named(const Pair& pair, const Separation& separation) const {
  const std::string& other = pair.with_body ? bodyLabel(scene_.bodies[pair.other]) : scene_.obstacles[pair.other].name;
  return {separation.distance, separation.distance - scene_.clearance, bodyLabel(scene_.bodies[pair.body]), other,
          separation.point};
}

std::optional<Clearance> CollisionWorld::findLostBody(std::span<const Isometry3d> X_WL) const {
  for (const Body& body : scene_.bodies)
    if (!X_WL[body.frame_index].matrix().allFinite()) {
      Clearance lost;
      lost.body = bodyLabel(body);
      lost.other = "its pose is not a number";
      return lost;
    }
  return std::nullopt;
}

Clearance CollisionWorld::closest(std::span<const Isometry3d> X_WL, double stop_below) const {
  const Placed placed = place(X_WL);
  if (auto lost = findLostBody(X_WL)) return *lost;
  const Pair* nearest = nullptr;
  Separation least{std::numeric_limits<double>::infinity(), Vector3d::Zero()};
  for (const Pair& pair : pairs_) {
    if (isFarther(pair, placed, least.distance)) continue;
    const Separation found = pairSeparation(pair, placed);
    if (found.distance >= least.distance) continue;
    least = found;
    nearest = &pair;
    if (least.distance - scene_.clearance < stop_below) break;
  }
  if (nearest) return named(*nearest, least);
  Clearance nothing;
  nothing.distance = nothing.margin = std::numeric_limits<double>::infinity();
  return nothing;
}

std::vector<PairClearance> CollisionWorld::allPairs(std::span<const Isometry3d> X_WL) const {
  const Placed placed = place(X_WL);
  std::vector<PairClearance> all;
  for (const Pair& pair : pairs_) all.push_back({named(pair, pairSeparation(pair, placed)), false});
  for (const Pair& pair : allowed_pairs_) {
    all.push_back({named(pair, pairSeparation(pair, placed)), true});
    all.back().clearance.margin = std::numeric_limits<double>::infinity();
  }
  std::ranges::stable_sort(all, {}, [](const PairClearance& pair) { return pair.clearance.distance; });
  return all;
}

}  // namespace tubeplan::planner
