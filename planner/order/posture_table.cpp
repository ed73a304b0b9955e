#include "planner/order/posture_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "deflection/resized.hpp"

namespace tubeplan::planner {
namespace {

constexpr int kMostTabulated = 1200;  // number of postures up to which the costs of all moves fit the caches

/// Returns values given by posture and joint, rearranged so that the values of one joint for all postures of a node are
/// adjacent.
std::vector<double> jointByJoint(const PostureTable& table, const std::vector<double>& values, int stride) {
  std::vector<double> by_joint;
  by_joint.reserve(static_cast<std::size_t>(table.postures() * table.joints()));
  for (int node = 0; node < table.nodes(); ++node)
    for (int j = 0; j < table.joints(); ++j)
      for (int p = table.first(node); p < table.last(node); ++p)
        by_joint.push_back(values[static_cast<std::size_t>(p * stride + j)]);
  return by_joint;
}

/// Applies unitMoveDuration() to each element of `seconds`: cruising times on input, durations on output [s].
template <class Ramps>
void makeDurations(Eigen::ArrayXd& seconds, const Ramps& ramps) {
  seconds = (ramps > seconds.square()).select(2 * ramps.sqrt(), (seconds > 0).select(seconds + ramps / seconds, 0.));
}

}  // namespace

PostureTable::PostureTable(const Route& route)
    : route_(&route),
      visits_(static_cast<int>(route.visits.size())),
      joints_(static_cast<int>(route.speeds.max_speed.size())),
      stride_((joints_ + kStep - 1) / kStep * kStep),
      has_extra_(static_cast<bool>(route.extra_time)),
      with_extra_(route.with_extra) {
  assert(with_extra_.empty() || with_extra_.size() == route.visits.size());
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
  by_joint_ = jointByJoint(*this, by_speed_, stride_);
  if (!one_ratio_) by_joint_acceleration_ = jointByJoint(*this, by_acceleration_, stride_);
}

void PostureTable::greatestDifferences(const std::vector<double>& by_joint, const std::vector<double>& values, int node,
                                       int posture, Eigen::ArrayXd& greatest) const {
  const double* posture_values = &values[static_cast<std::size_t>(posture) * static_cast<std::size_t>(stride_)];
  const int count = last(node) - first(node);
  const double* node_values = &by_joint[static_cast<std::size_t>(first(node)) * static_cast<std::size_t>(joints_)];
  using OfJoint = Eigen::Map<const Eigen::ArrayXd>;
  deflection::resizeOrEmpty(greatest, count, 1);
  greatest = (OfJoint(node_values, count) - posture_values[0]).abs();
  for (int j = 1; j < joints_; ++j)
    greatest = greatest.max((OfJoint(node_values + j * count, count) - posture_values[j]).abs());
}

void PostureTable::tabulate() {
  if (postures() > kMostTabulated) return;
  const auto count = static_cast<std::size_t>(postures());
  std::vector<double> costs(count * count);
  Eigen::ArrayXd times;
  for (int p = 0; p < postures(); ++p)
    for (int node = 0; node < nodes(); ++node) {
      costsTo(node, p, times);
      std::copy_n(times.data(), times.size(), &costs[static_cast<std::size_t>(p) * count + first(node)]);
    }
  costs_ = std::move(costs);
}

void PostureTable::costsTo(int node, int posture, Eigen::ArrayXd& times) const {
  if (!costs_.empty()) {
    const auto row = static_cast<std::size_t>(posture) * static_cast<std::size_t>(postures());
    times = Eigen::Map<const Eigen::ArrayXd>(&costs_[row + first(node)], last(node) - first(node));
    return;
  }
  greatestDifferences(by_joint_, by_speed_, node, posture, times);
  if (one_ratio_) {
    makeDurations(times, ratio_ * times);
  } else {
    Eigen::ArrayXd ramps;
    greatestDifferences(by_joint_acceleration_, by_acceleration_, node, posture, ramps);
    makeDurations(times, ramps);
  }
  if (!mayCostExtra(node) || !mayCostExtra(nodeOf(posture))) return;
  for (int q = first(node); q < last(node); ++q) times[q - first(node)] += extra(posture, q);
}

int PostureTable::sideOf(int node, const std::vector<char>& inside) const {
  const auto count = std::count(inside.begin() + first(node), inside.begin() + last(node), 1);
  return count == 0 ? 0 : count == last(node) - first(node) ? 1 : -1;
}

int PostureTable::nearestPosture(int posture, int node) const {
  Eigen::ArrayXd times;
  costsTo(node, posture, times);
  Eigen::Index nearest = 0;
  times.minCoeff(&nearest);
  return first(node) + static_cast<int>(nearest);
}

double PostureTable::extra(int a, int b) const {
  const auto visitOf = [&](int node) {
    return node == start_node_ ? kStartPosture : node == end_node_ ? kEndPosture : node;
  };
  const int node_a = node_of_[a], node_b = node_of_[b];
  if (!mayCostExtra(node_a) || !mayCostExtra(node_b)) return 0;
  const double seconds = route_->extra_time(visitOf(node_a), a - first_[node_a], visitOf(node_b), b - first_[node_b]);
  assert(seconds >= 0);
  return std::min(seconds, kForbiddenTime);
}

}  // namespace tubeplan::planner
