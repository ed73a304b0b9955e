// All postures of a route in one flat table, with the times of moves between them. Internal to the ordering.
//
// Nodes are the visits, then the start posture, then the end posture, if given. Postures of a node are consecutive.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Replacement for an infinite extra time [s], so that differences stay finite.
inline constexpr double kForbiddenTime = 1e6;

class PostureTable {
 public:
  /// Builds the table. `route` must have no problems (findRouteProblems()), and must outlive the table.
  explicit PostureTable(const Route& route);

  [[nodiscard]] int visits() const { return visits_; }
  [[nodiscard]] int nodes() const { return static_cast<int>(first_.size()) - 1; }
  [[nodiscard]] int postures() const { return first_.back(); }
  [[nodiscard]] int startNode() const { return start_node_; }  ///< node of the start posture; -1 if there is none
  [[nodiscard]] int endNode() const { return end_node_; }      ///< node of the end posture; -1 if there is none
  [[nodiscard]] int first(int node) const { return first_[node]; }
  [[nodiscard]] int last(int node) const { return first_[node + 1]; }  ///< one past the node's last posture
  [[nodiscard]] int nodeOf(int posture) const { return node_of_[posture]; }
  [[nodiscard]] int joints() const { return joints_; }
  /// Returns the joint value divided by the maximum speed of the joint [s]: its difference between two postures is a
  /// lower bound on the time of a move between them.
  [[nodiscard]] double scaled(int posture, int joint) const { return by_speed_[posture * stride_ + joint]; }

  /// Returns the time of the straight move between two postures [s], without extra time.
  [[nodiscard]] double straight(int a, int b) const {
    const double cruise_seconds = greatestDifference(by_speed_, a, b);
    return unitMoveDuration(cruise_seconds,
                            one_ratio_ ? ratio_ * cruise_seconds : greatestDifference(by_acceleration_, a, b));
  }
  /// Returns the time of the straight move plus extra time [s]; a forbidden move costs `kForbiddenTime` in addition.
  [[nodiscard]] double cost(int a, int b) const {
    if (!costs_.empty()) return costs_[static_cast<std::size_t>(a) * static_cast<std::size_t>(postures()) + b];
    return has_extra_ ? straight(a, b) + extra(a, b) : straight(a, b);
  }
  /// Computes the costs of all moves once, if there are not too many of them, so that they are looked up from then on.
  void tabulate();
  /// Computes the costs [s] from `posture` to all postures of `node`, bitwise identical to cost().
  void costsTo(int node, int posture, Eigen::ArrayXd& times) const;
  /// Returns 1 if all postures of `node` are in the set, 0 if none is, -1 if only some are.
  [[nodiscard]] int sideOf(int node, const std::vector<char>& inside) const;
  /// Returns the posture of `node` that costs least to reach from `posture`.
  [[nodiscard]] int nearestPosture(int posture, int node) const;

 private:
  static constexpr int kStep = 4;  // number of joints compared at once

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
  int stride_;  // number of joints, padded with zeros to a multiple of kStep
  int start_node_ = -1;
  int end_node_ = -1;
  bool has_extra_;
  // true if all joints have the same ratio of speed to acceleration, so that one difference gives both times
  bool one_ratio_ = false;
  double ratio_ = 0;  // ratio of speed to acceleration [s]
  std::vector<int> first_, node_of_;
  // flag for each visit, nonzero if a move to or from it may have extra time; empty means that any may
  std::vector<char> with_extra_;
  std::vector<double> by_speed_;         // posture x joint: value / max_speed [s]
  std::vector<double> by_acceleration_;  // posture x joint: value / max_acceleration [s^2]
  std::vector<double> costs_;            // posture x posture: cost [s]; empty unless tabulated
  // Values of `by_speed_` and `by_acceleration_`, for each node as joint x posture.
  std::vector<double> by_joint_, by_joint_acceleration_;
};

}  // namespace tubeplan::planner
