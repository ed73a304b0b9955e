// Routes for the tests of ordering: random postures, and lattices reached by a two-link arm with the elbow on either
// side.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "planner/order/route.hpp"
#include "tests/planner/random_draws.hpp"
#include "tests/units.hpp"

namespace tubeplan::planner {

using testing::uniform;

inline Eigen::VectorXd postureWithinOne(std::mt19937_64& random, int joints) {
  return testing::randomPosture(random, joints, -1, 1);
}

/// Returns equal limits for all joints: 6 deg/s and 12 deg/s^2.
inline JointSpeeds evenSpeeds(int joints) {
  return {Eigen::VectorXd::Constant(joints, 6 * kDegree), Eigen::VectorXd::Constant(joints, 12 * kDegree)};
}

/// Returns a route with one to `most_branches` random postures for each visit, different limits for each joint, and a
/// start and an end posture if requested.
inline Route randomRoute(std::mt19937_64& random, int visits, int most_branches, bool start, bool end) {
  Route route;
  route.speeds = {Eigen::Vector3d(1, 0.5, 2), Eigen::Vector3d(2, 4, 1)};
  for (int v = 0; v < visits; ++v) {
    Visit visit;
    const int branches = 1 + static_cast<int>(random() % static_cast<std::uint64_t>(most_branches));
    for (int b = 0; b < branches; ++b) visit.branches.push_back(postureWithinOne(random, 3));
    route.visits.push_back(visit);
  }
  if (start) route.start = postureWithinOne(random, 3);
  if (end) route.end = postureWithinOne(random, 3);
  return route;
}

/// Returns the postures with the elbow left and right, for links of 1.6 m and a wrist that keeps the tool's direction.
/// (x, y) is the hole's position [m], within reach.
inline Visit twoElbows(double x, double y) {
  constexpr double kLink = 1.6;
  const double elbow = std::acos((x * x + y * y) / (2 * kLink * kLink) - 1);
  Visit visit;
  for (const double q2 : {elbow, -elbow}) {
    const double q1 = std::atan2(y, x) - q2 / 2;
    visit.branches.emplace_back(Eigen::Vector3d(q1, q2, -q1 - q2));
  }
  return visit;
}

/// Returns a route of side x side holes with the given pitch [m], starting at (0.9, -0.6) m; `branches` is 1 or 2.
inline Route latticeRoute(int side, double pitch, int branches) {
  Route route;
  route.speeds = evenSpeeds(3);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      Visit visit = twoElbows(0.9 + pitch * row, -0.6 + pitch * column);
      visit.branches.resize(static_cast<std::size_t>(branches));
      route.visits.push_back(visit);
    }
  }
  return route;
}

/// Returns the time [s] of an order with the given branches, computed directly from the postures.
inline double timeOf(const Route& route, const std::vector<int>& order, const std::vector<int>& branches) {
  struct Stop {
    int visit, branch;
    Eigen::VectorXd posture;
  };
  std::vector<Stop> stops;
  if (route.start) stops.push_back({kStartPosture, 0, *route.start});
  for (std::size_t k = 0; k < order.size(); ++k) {
    stops.push_back({order[k], branches[k], route.visits.at(order[k]).branches.at(branches[k])});
  }
  if (route.end) stops.push_back({kEndPosture, 0, *route.end});
  double time = 0;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const Stop &a = stops[k - 1], &b = stops[k];
    time += straightMoveDuration(a.posture, b.posture, route.speeds);
    if (route.extra_time) time += route.extra_time(a.visit, a.branch, b.visit, b.branch);
  }
  return time;
}

/// Returns the shortest time [s] over all choices of branches for an order, by exhaustive search.
inline double exhaustiveBranches(const Route& route, const std::vector<int>& order) {
  std::vector<int> branches(order.size(), 0);
  double best = std::numeric_limits<double>::infinity();
  for (;;) {
    best = std::min(best, timeOf(route, order, branches));
    std::size_t k = 0;
    while (k < order.size() && ++branches[k] == static_cast<int>(route.visits[order[k]].branches.size()))
      branches[k++] = 0;
    if (k == order.size()) return best;
  }
}

}  // namespace tubeplan::planner
