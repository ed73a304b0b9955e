#include "planner/lipschitz_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace tubeplan::planner {

namespace {

struct Stretch {
  double from, to, distance_from, distance_to;
  /// Least distance that could hide between the two ends.
  double bound(double length) const { return (distance_from + distance_to - (to - from) * length) / 2; }
};

const Capsule& capsuleAround(const Body& body) { return static_cast<const Solid&>(*body.shape).around(); }

Capsule placed(const Eigen::Isometry3d& X, const Capsule& capsule) {
  return {X * capsule.from, X * capsule.to, capsule.radius};
}

/// Two things that may not touch, and what one look at the capsule's middle tells of them.
struct Pair {
  Capsule capsule;  ///< in the other's frame
  const Shape* other;
  const std::string *body_name, *other_name;
  double bound;  ///< m, lower bound of the distance
};

Pair pairOf(const Capsule& capsule, const Body& body, const Shape& other, const std::string& other_name) {
  const double half_length = (capsule.to - capsule.from).norm() / 2;
  const double middle = other.pointDistance((capsule.from + capsule.to) / 2);
  return {capsule, &other, &bodyLabel(body), &other_name, middle - half_length - capsule.radius};
}

std::vector<Pair> pairsOf(const Scene& scene, std::span<const Eigen::Isometry3d> X_WL) {
  std::vector<Pair> pairs;
  const std::vector<int> group = rigidGroups(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Capsule in_world = placed(X_WL[static_cast<std::size_t>(body.frame_index)], capsuleAround(body));
    for (const auto& obstacle : scene.obstacles)
      if (!mayTouch(obstacle, body)) pairs.push_back(pairOf(in_world, body, *obstacle.shape, obstacle.name));
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      const Body& other = scene.bodies[j];
      if (std::abs(group[i] - group[j]) <= 1 || mayTouch(body, other)) continue;
      const Eigen::Isometry3d X_OW = X_WL[static_cast<std::size_t>(other.frame_index)].inverse();
      pairs.push_back(pairOf(placed(X_OW, in_world), body, *other.shape, bodyLabel(other)));
    }
  }
  return pairs;
}

}  // namespace

double lipschitzDistance(const Capsule& capsule, const Shape& shape, const LipschitzOptions& options) {
  assert(options.accuracy > 0);
  const Eigen::Vector3d along = capsule.to - capsule.from;
  const double length = along.norm();
  // A capsule that is nowhere is clear of nothing.
  if (!std::isfinite(length)) return -std::numeric_limits<double>::infinity();
  const auto at = [&](double s) { return shape.pointDistance(capsule.from + s * along) - capsule.radius; };
  std::vector<Stretch> open{{0, 1, at(0), at(1)}};
  double least = std::min(open.front().distance_from, open.front().distance_to);
  double proved = least;
  // Coarse stretches before fine ones: `least` is then soon near its end value, and most stretches need no halving.
  for (std::size_t next = 0; next < open.size(); ++next) {
    const Stretch stretch = open[next];
    const double slack = std::max(options.accuracy, options.share * (least - options.required));
    const double bound = stretch.bound(length);
    if (bound >= std::min(least - slack, options.enough)) {
      proved = std::min(proved, bound);
      continue;
    }
    const double middle = (stretch.from + stretch.to) / 2, distance = at(middle);
    least = std::min(least, distance);
    open.push_back({stretch.from, middle, stretch.distance_from, distance});
    open.push_back({middle, stretch.to, distance, stretch.distance_to});
  }
  return std::min(proved, least);
}

double lipschitzMargin(const Scene& scene, std::span<const Eigen::Isometry3d> X_WL, double accuracy, double share,
                       std::string* names) {
  std::vector<Pair> pairs = pairsOf(scene, X_WL);
  std::ranges::stable_sort(pairs, {}, &Pair::bound);
  LipschitzOptions options{accuracy, share, scene.clearance};
  for (const Pair& pair : pairs) {
    if (pair.bound >= options.enough) break;
    const double distance = lipschitzDistance(pair.capsule, *pair.other, options);
    if (distance >= options.enough) continue;
    options.enough = distance;
    if (names) *names = *pair.body_name + ", " + *pair.other_name;
  }
  return options.enough - scene.clearance;
}

}  // namespace tubeplan::planner
