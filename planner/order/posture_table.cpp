#include "planner/order/posture_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {

PostureTable::PostureTable(const Route& route)
    : route_(&route),
      visits_(static_cast<int>(route.visits.size())),
      joints_(static_cast<int>(route.speeds.max_speed.size())),
      stride_((joints_ + kStep - 1) / kStep * kStep),
      has_extra_(static_cast<bool>(route.extra_time)) {
  first_.push_back(0);
  const auto addPosture = [&](const Eigen::VectorXd& q) {
    for (int j = 0; j < stride_; ++j) {
      by_speed_.push_back(j < joints_ ? q[j] / route.speeds.max_speed[j] : 0);
      by_acceleration_.push_back(j < joints_ ? q[j] / route.speeds.max_acceleration[j] : 0);
    }
    node_of_.push_back(nodes());
  };
  const auto closeNode = [&] { first_.push_back(static_cast<int>(node_of_.size())); };
  for (const Visit& visit : route.visits) {
    for (const Eigen::VectorXd& q : visit.branches) addPosture(q);
    closeNode();
  }
  const auto addEnd = [&](const std::optional<Eigen::VectorXd>& q) {
    if (!q) return -1;
    addPosture(*q);
    closeNode();
    return nodes() - 1;
  };
  start_node_ = addEnd(route.start);
  end_node_ = addEnd(route.end);
  const Eigen::ArrayXd ratio = route.speeds.max_speed.array() / route.speeds.max_acceleration.array();
  ratio_ = ratio[0];
  one_ratio_ = std::isfinite(ratio_) && (ratio == ratio_).all();
}

int PostureTable::sideOf(int node, const std::vector<char>& inside) const {
  const auto count = std::count(inside.begin() + first(node), inside.begin() + last(node), 1);
  return count == 0 ? 0 : count == last(node) - first(node) ? 1 : -1;
}

int PostureTable::nearestPosture(int posture, int node) const {
  int nearest = first(node);
  for (int q = nearest + 1; q < last(node); ++q) {
    if (cost(posture, q) < cost(posture, nearest)) nearest = q;
  }
  return nearest;
}

double PostureTable::extra(int a, int b) const {
  const auto visitOf = [&](int node) {
    return node == start_node_ ? kStartPosture : node == end_node_ ? kEndPosture : node;
  };
  const int node_a = node_of_[a], node_b = node_of_[b];
  const double seconds = route_->extra_time(visitOf(node_a), a - first_[node_a], visitOf(node_b), b - first_[node_b]);
  assert(seconds >= 0);
  return std::min(seconds, kForbiddenTime);
}

}  // namespace tubeplan::planner
