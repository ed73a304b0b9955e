// All postures of a route in one flat table, with the time of a move between two of them. Internal to the ordering.
//
// Nodes: the visits, then the start posture, then the end posture, where given. Postures of a node are consecutive.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Stands for an infinite extra time [s], so that differences stay finite.
inline constexpr double kForbiddenTime = 1e6;

class PostureTable {
 public:
  /// The route must be free of problems and outlive the table.
  explicit PostureTable(const Route& route);

  [[nodiscard]] int visits() const { return visits_; }
  [[nodiscard]] int nodes() const { return static_cast<int>(first_.size()) - 1; }
  [[nodiscard]] int postures() const { return first_.back(); }
  [[nodiscard]] int startNode() const { return start_node_; }  ///< -1 without
  [[nodiscard]] int endNode() const { return end_node_; }      ///< -1 without
  [[nodiscard]] int first(int node) const { return first_[node]; }
  [[nodiscard]] int last(int node) const { return first_[node + 1]; }  ///< one past
  [[nodiscard]] int nodeOf(int posture) const { return node_of_[posture]; }
  [[nodiscard]] int joints() const { return joints_; }
  /// Joint value over its greatest speed [s]: differences bound the time of a move from below.
  [[nodiscard]] double scaled(int posture, int joint) const { return by_speed_[posture * stride_ + joint]; }

  /// Time [s] along the straight line, without extra time.
  [[nodiscard]] double straight(int a, int b) const {
    const double cruise_seconds = greatestDifference(by_speed_, a, b);
    return unitMoveDuration(cruise_seconds,
                            one_ratio_ ? ratio_ * cruise_seconds : greatestDifference(by_acceleration_, a, b));
  }
  /// Straight line and extra time [s]; forbidden moves cost `kForbiddenTime`.
  [[nodiscard]] double cost(int a, int b) const { return has_extra_ ? straight(a, b) + extra(a, b) : straight(a, b); }
  /// The same to each posture of `node`, first to last; bit for bit what cost() has.
  void costsTo(int node, int posture, Eigen::ArrayXd& times) const;
  /// Of a set by posture: 1 where all postures of `node` are in it, 0 where none is, else -1.
  [[nodiscard]] int sideOf(int node, const std::vector<char>& inside) const;
  /// The posture of `node` that costs least to reach from `posture`.
  [[nodiscard]] int nearestPosture(int posture, int node) const;

 private:
  static constexpr int kStep = 4;  // joints compared at a time

  [[nodiscard]] double extra(int a, int b) const;
  [[nodiscard]] bool mayCostExtra(int node) const {
    return has_extra_ && (node >= visits_ || with_extra_.empty() || with_extra_[node]);
  }
  void greatestDifferences(const std::vector<double>& by_joint, const std::vector<double>& values, int node,
                           int posture, Eigen::ArrayXd& greatest) const;
  [[nodiscard]] double greatestDifference(const std::vector<double>& values, int a, int b) const {
    const double* x = &values[static_cast<std::size_t>(a) * static_cast<std::size_t>(stride_)];
    const double* y = &values[static_cast<std::size_t>(b) * static_cast<std::size_t>(stride_)];
    using Four = Eigen::Map<const Eigen::Array4d>;
    double greatest = (Four(x) - Four(y)).abs().maxCoeff();
    for (int j = kStep; j < stride_; j += kStep)
      greatest = std::max(greatest, (Four(x + j) - Four(y + j)).abs().maxCoeff());
    return greatest;
  }

  const Route* route_;
  int visits_;
  int joints_;
  int stride_;  // joints, and noughts up to a whole number of steps
  int start_node_ = -1;
  int end_node_ = -1;
  bool has_extra_;
  bool one_ratio_ = false;  // of speed to acceleration for all joints: one difference decides
  double ratio_ = 0;        // s
  std::vector<int> first_, node_of_;
  std::vector<char> with_extra_;         // by visit: whether a move to or from it may cost extra; empty: any may
  std::vector<double> by_speed_;         // posture x joint: value / max_speed
  std::vector<double> by_acceleration_;  // posture x joint: value / max_acceleration
  std::vector<double> by_joint_, by_joint_acceleration_;  // the same node by node: joint x posture
};

}  // namespace tubeplan::planner
