#include "planner/lipschitz_distance.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace tubeplan::planner {

namespace {

struct Stretch {
  double from, to, distance_from, distance_to;
  /// Least distance that could hide between the two ends.
  double bound(double length) const { return (distance_from + distance_to - (to - from) * length) / 2; }
};

const Capsule& capsuleAround(const Body& body) { return static_cast<const Solid&>(*body.shape).around(); }

Capsule placed(const Eigen::Isometry3d& X, const Capsule& capsule) { return {X * capsule.from, X * capsule.to, capsule.radius}; }

}  // namespace

double lipschitzDistance(const Capsule& capsule, const Shape& shape, double accuracy) {
  const Eigen::Vector3d along = capsule.to - capsule.from;
  const double length = along.norm();
  const auto at = [&](double s) { return shape.pointDistance(capsule.from + s * along); };
  const auto worse = [length](const Stretch& a, const Stretch& b) { return a.bound(length) > b.bound(length); };
  std::priority_queue<Stretch, std::vector<Stretch>, decltype(worse)> open(worse);
  const Stretch whole{0, 1, at(0), at(1)};
  double least = std::min(whole.distance_from, whole.distance_to);
  open.push(whole);
  while (open.top().bound(length) < least - accuracy) {
    const Stretch top = open.top();
    open.pop();
    const double middle = (top.from + top.to) / 2, distance = at(middle);
    least = std::min(least, distance);
    open.push({top.from, middle, top.distance_from, distance});
    open.push({middle, top.to, distance, top.distance_to});
  }
  return std::min(least, open.top().bound(length)) - capsule.radius;
}

double lipschitzMargin(const Scene& scene, std::span<const Eigen::Isometry3d> X_WL, double accuracy, std::string* names) {
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](double distance, const std::string& body, const std::string& other) {
    if (!(distance - scene.clearance >= least)) {
      least = distance - scene.clearance;
      if (names) *names = body + ", " + other;
    }
  };
  const std::vector<int> group = rigidGroups(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Eigen::Isometry3d& X_WL_body = X_WL[static_cast<std::size_t>(body.frame_index)];
    const Capsule in_world = placed(X_WL_body, capsuleAround(body));
    for (const auto& obstacle : scene.obstacles)
      if (!mayTouch(obstacle, body)) consider(lipschitzDistance(in_world, *obstacle.shape, accuracy), bodyLabel(body), obstacle.name);
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      const Body& other = scene.bodies[j];
      if (std::abs(group[i] - group[j]) <= 1 || mayTouch(body, other)) continue;
      const Eigen::Isometry3d X_OB = X_WL[static_cast<std::size_t>(other.frame_index)].inverse() * X_WL_body;
      consider(lipschitzDistance(placed(X_OB, capsuleAround(body)), *other.shape, accuracy), bodyLabel(body), bodyLabel(other));
    }
  }
  return least;
}

}  // namespace tubeplan::planner
