// Nearest pair of bodies in one posture, computed pair by pair without kernels. It serves as the reference for
// NearestPairs, and for tests with toy arms.
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/collision/clearance.hpp"
#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

struct PairClearance {
  Clearance clearance;
  bool allowed = false;  ///< true if the pair may touch; closest() then ignores it, and its margin is infinite
};

class CollisionWorld {
 public:
  /// `scene` must have no problems (findSceneProblems()).
  explicit CollisionWorld(Scene scene);

  /// Returns the pair with the smallest margin for link frames X_WL (one per link of the scene, deflected or not).
  /// Pairs that may touch are ignored.
  [[nodiscard]] Clearance closest(std::span<const Eigen::Isometry3d> X_WL) const;

  /// Returns every pair, nearest first, including pairs that may touch but not pairs of bodies that share a joint.
  [[nodiscard]] std::vector<PairClearance> allPairs(std::span<const Eigen::Isometry3d> X_WL) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  struct Pair {
    int body;
    int other;  ///< index of a body if `with_body`, else of an obstacle
    bool with_body;
    const Solid* solid;  ///< solid of the other body or obstacle; null for a region or a mesh
  };
  struct Placed;  ///< poses of all bodies in one posture

  void addPair(const Pair& pair, bool allowed);
  [[nodiscard]] Placed place(std::span<const Eigen::Isometry3d> X_WL) const;
  [[nodiscard]] bool isFarther(const Pair& pair, const Placed& placed, double distance) const;
  [[nodiscard]] Separation pairSeparation(const Pair& pair, const Placed& placed) const;
  [[nodiscard]] Clearance named(const Pair& pair, const Separation& separation) const;
  [[nodiscard]] std::optional<Clearance> findLostBody(std::span<const Eigen::Isometry3d> X_WL) const;

  Scene scene_;
  std::vector<const Solid*> solids_;  ///< solid of each body
  std::vector<Pair> pairs_;           ///< pairs that must keep clear
  std::vector<Pair> allowed_pairs_;
};

struct CollisionWorld::Placed {
  std::span<const Eigen::Isometry3d> X_WL;
  std::vector<Capsule> around_W;  ///< capsule around each body, in the world frame
};

inline CollisionWorld::CollisionWorld(Scene scene) : scene_(std::move(scene)) {
  assert(findSceneProblems(scene_).empty());
  for (const Body& body : scene_.bodies) solids_.push_back(dynamic_cast<const Solid*>(body.shape.get()));
  for (int i = 0; i < static_cast<int>(scene_.bodies.size()); ++i) {
    for (int k = 0; k < static_cast<int>(scene_.obstacles.size()); ++k) {
      const Obstacle& obstacle = scene_.obstacles[k];
      addPair({i, k, false, dynamic_cast<const Solid*>(obstacle.shape.get())}, mayTouch(obstacle, scene_.bodies[i]));
    }
    for (int k = 0; k < i; ++k)
      if (areJudged(scene_, k, i)) addPair({i, k, true, solids_[k]}, mayTouch(scene_.bodies[k], scene_.bodies[i]));
  }
}

inline void CollisionWorld::addPair(const Pair& pair, bool allowed) {
  (allowed ? allowed_pairs_ : pairs_).push_back(pair);
}

inline CollisionWorld::Placed CollisionWorld::place(std::span<const Eigen::Isometry3d> X_WL) const {
  assert(X_WL.size() == scene_.links.size());
  Placed placed{X_WL, {}};
  placed.around_W.reserve(solids_.size());
  for (std::size_t i = 0; i < solids_.size(); ++i)
    placed.around_W.push_back(transformed(X_WL[scene_.bodies[i].frame_index], solids_[i]->around()));
  return placed;
}

/// Returns true if the pair is certainly at least `distance` [m] apart, judged by the capsules around both bodies or,
/// if the obstacle is not a solid, by isFartherThan().
inline bool CollisionWorld::isFarther(const Pair& pair, const Placed& placed, double distance) const {
  const Capsule& a = placed.around_W[pair.body];
  if (!pair.solid) return scene_.obstacles[pair.other].shape->isFartherThan(distance, a);
  const Capsule& b = pair.with_body ? placed.around_W[pair.other] : pair.solid->around();
  return separation(a, b).distance >= distance;
}

inline Separation CollisionWorld::pairSeparation(const Pair& pair, const Placed& placed) const {
  const Eigen::Isometry3d& X_WB = placed.X_WL[scene_.bodies[pair.body].frame_index];
  const bool is_capsule = solids_[pair.body]->isCapsule();
  if (!pair.with_body) {
    const Shape& obstacle = *scene_.obstacles[pair.other].shape;
    return is_capsule ? obstacle.separationFrom(placed.around_W[pair.body])
                      : obstacle.separationFrom(X_WB, *solids_[pair.body]);
  }
  if (is_capsule && pair.solid->isCapsule()) return separation(placed.around_W[pair.body], placed.around_W[pair.other]);
  return separation(X_WB, *solids_[pair.body], placed.X_WL[scene_.bodies[pair.other].frame_index], *pair.solid);
}

inline Clearance CollisionWorld::named(const Pair& pair, const Separation& separation) const {
  const std::string& other = pair.with_body ? bodyLabel(scene_.bodies[pair.other]) : scene_.obstacles[pair.other].name;
  return {separation.distance, separation.distance - scene_.clearance, bodyLabel(scene_.bodies[pair.body]), other,
          separation.point};
}

inline std::optional<Clearance> CollisionWorld::findLostBody(std::span<const Eigen::Isometry3d> X_WL) const {
  for (const Body& body : scene_.bodies)
    if (!X_WL[body.frame_index].matrix().allFinite()) {
      Clearance lost;
      lost.body = bodyLabel(body);
      lost.other = "its pose is not a number";
      return lost;
    }
  return std::nullopt;
}

inline Clearance CollisionWorld::closest(std::span<const Eigen::Isometry3d> X_WL) const {
  const Placed placed = place(X_WL);
  if (auto lost = findLostBody(X_WL)) return *lost;
  const Pair* nearest = nullptr;
  Separation least{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  for (const Pair& pair : pairs_) {
    if (isFarther(pair, placed, least.distance)) continue;
    const Separation found = pairSeparation(pair, placed);
    if (found.distance >= least.distance) continue;
    least = found;
    nearest = &pair;
  }
  if (nearest) return named(*nearest, least);
  Clearance nothing;
  nothing.distance = nothing.margin = std::numeric_limits<double>::infinity();
  return nothing;
}

inline std::vector<PairClearance> CollisionWorld::allPairs(std::span<const Eigen::Isometry3d> X_WL) const {
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
