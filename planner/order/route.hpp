// The ordering problem: tubes to visit, the postures (branches) that reach each, and what a move between two costs.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

/// One tube: the postures that reach it [rad], at least one.
struct Visit {
  std::vector<Eigen::VectorXd> branches;
};

/// Stand for the start and the end posture (branch 0) where a visit's index is asked for.
inline constexpr int kStartPosture = -1;
inline constexpr int kEndPosture = -2;

/// Time [s] that a move costs beyond its straight line, >= 0, the same both ways; infinite for a move that must not be
/// made. Arguments: visit and branch at one end, visit and branch at the other.
using ExtraTime = std::function<double(int visit_a, int branch_a, int visit_b, int branch_b)>;

/// A sparse table of extra times; usable as an `ExtraTime`. Moves that it does not know cost nothing extra.
class EdgePenalties {
 public:
  /// Sets (replaces) the extra time [s] of one move, in both senses. At most 2^24 visits of 255 branches.
  void set(int visit_a, int branch_a, int visit_b, int branch_b, double seconds);
  [[nodiscard]] double operator()(int visit_a, int branch_a, int visit_b, int branch_b) const;
  [[nodiscard]] std::size_t size() const { return seconds_.size(); }
  /// Whether any move to or from a visit costs extra.
  [[nodiscard]] bool touches(int visit) const {
    const auto place = static_cast<std::size_t>(visit + 2);
    return place < touched_.size() && touched_[place];
  }

 private:
  std::unordered_map<std::uint64_t, double> seconds_;
  std::vector<char> touched_;  // by visit: most moves are answered without a search
};

/// Visit every tube once, in any order, from rest to rest. Without `start` (`end`) the route begins (ends) at any tube.
struct Route {
  std::vector<Visit> visits;
  JointSpeeds speeds;
  std::optional<Eigen::VectorXd> start;  ///< rad
  std::optional<Eigen::VectorXd> end;    ///< rad
  ExtraTime extra_time;                  ///< may be empty
  /// By visit: whether a move to or from it may take extra time. Empty: any may.
  std::vector<char> with_extra;
};

/// What is wrong with the problem, one sentence each; empty when it can be solved.
[[nodiscard]] std::vector<std::string> findRouteProblems(const Route& route);

}  // namespace tubeplan::planner
