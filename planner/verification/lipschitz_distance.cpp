#include "planner/verification/lipschitz_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

namespace {

struct CapsuleStretch {
  double from, to, distance_from, distance_to;
  /// Returns a lower bound of the distance of all axis points between the segment's two ends [m].
  double bound(double length) const { return (distance_from + distance_to - (to - from) * length) / 2; }
};

const Solid& solidOf(const Body& body) { return static_cast<const Solid&>(*body.shape); }

const Capsule& capsuleAround(const Body& body) { return solidOf(body).around(); }

Capsule placed(const Eigen::Isometry3d& X, const Capsule& capsule) {
  return {X * capsule.from, X * capsule.to, capsule.radius};
}

}  // namespace

double lipschitzDistance(const Capsule& capsule, const Shape& shape, const LipschitzOptions& options) {
  assert(options.accuracy > 0);
  const Eigen::Vector3d along = capsule.to - capsule.from;
  const double length = along.norm();
  // A capsule at an undefined position is treated as touching everything.
  if (!std::isfinite(length)) return -std::numeric_limits<double>::infinity();
  const auto at = [&](double s) { return shape.pointDistance(capsule.from + s * along) - capsule.radius; };
  std::vector<CapsuleStretch> open{{0, 1, at(0), at(1)}};
  double least = std::min(open.front().distance_from, open.front().distance_to);
  double proved = least;
  // Coarse segments come before fine ones, so that `least` is soon near its final value and most segments need no
  // bisection.
  for (std::size_t next = 0; next < open.size(); ++next) {
    const CapsuleStretch stretch = open[next];
    const double slack = std::max(options.accuracy, options.share * (least - options.required));
    const double bound = stretch.bound(length);
    if (bound >= std::min(least - slack, options.sufficient)) {
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

LipschitzMargins::LipschitzMargins(const Scene& scene, const BasePadding& padding) : scene_(scene), padding_(padding) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t k = 0; k < scene.obstacles.size(); ++k)
      if (!mayTouch(scene.obstacles[k], scene.bodies[i])) pairs_.push_back({i, k, false});
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j)
      if (areJudged(scene, static_cast<int>(i), static_cast<int>(j)) && !mayTouch(scene.bodies[i], scene.bodies[j]))
        pairs_.push_back({i, j, true});
  }
}

LipschitzMargins::PairEstimate LipschitzMargins::estimateOf(const Pair& pair,
                                                            std::span<const Eigen::Isometry3d> X_WL) const {
  const auto frameOf = [&](const Body& body) -> const Eigen::Isometry3d& {
    return X_WL[static_cast<std::size_t>(body.frame_index)];
  };
  const Body& body = scene_.bodies[pair.body];
  Capsule capsule = placed(frameOf(body), capsuleAround(body));
  const double padding = pair.with_body || padding_.isNone()
                             ? 0
                             : padding_.towards(*scene_.obstacles[pair.other].shape, capsule, body.frame_index);
  if (pair.with_body) capsule = placed(frameOf(scene_.bodies[pair.other]).inverse(), capsule);
  const Shape& other = pair.with_body ? *scene_.bodies[pair.other].shape : *scene_.obstacles[pair.other].shape;
  const double half_length = (capsule.to - capsule.from).norm() / 2;
  const double middle = other.pointDistance((capsule.from + capsule.to) / 2);
  return {&pair, capsule, &other, padding, middle - half_length - capsule.radius - padding};
}

/// Returns the gap between a body that is not a capsule and the other shape of the pair. Supporting planes on both
/// sides of the gap prove it, in any direction.
double LipschitzMargins::gapOf(const PairEstimate& estimate, std::span<const Eigen::Isometry3d> X_WL) const {
  const auto frameOf = [&](const Body& body) { return X_WL[static_cast<std::size_t>(body.frame_index)]; };
  const Body& body = scene_.bodies[estimate.pair->body];
  if (!estimate.pair->with_body) return estimate.other->separationFrom(frameOf(body), solidOf(body)).distance;
  const Body& other = scene_.bodies[estimate.pair->other];
  return separation(frameOf(body), solidOf(body), frameOf(other), solidOf(other)).distance;
}

double LipschitzMargins::at(std::span<const Eigen::Isometry3d> X_WL, double accuracy, double share,
                            std::string* names) {
  estimates_.clear();
  for (const Pair& pair : pairs_) estimates_.push_back(estimateOf(pair, X_WL));
  std::ranges::stable_sort(estimates_, {}, &PairEstimate::bound);
  double sufficient = std::numeric_limits<double>::infinity();
  const Pair* nearest = nullptr;
  for (const PairEstimate& estimate : estimates_) {
    if (estimate.bound >= sufficient) break;
    const LipschitzOptions options{accuracy, share, scene_.clearance + estimate.padding, sufficient + estimate.padding};
    double distance = lipschitzDistance(estimate.capsule, *estimate.other, options) - estimate.padding;
    if (distance < sufficient && !solidOf(scene_.bodies[estimate.pair->body]).isCapsule())
      distance = std::max(distance, gapOf(estimate, X_WL) - estimate.padding);
    if (distance >= sufficient) continue;
    sufficient = distance;
    nearest = estimate.pair;
  }
  if (names && nearest)
    *names = bodyLabel(scene_.bodies[nearest->body]) + ", " +
             (nearest->with_body ? bodyLabel(scene_.bodies[nearest->other]) : scene_.obstacles[nearest->other].name);
  return sufficient - scene_.clearance;
}

}  // namespace tubeplan::planner
