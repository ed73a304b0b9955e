// The ordering problem: tubes to visit, the postures (branches) that reach each, and the time of a move between two.
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

/// A tube, with one or more postures that reach it [rad].
struct Visit {
  std::vector<Eigen::VectorXd> branches;
};

/// Values of a visit's index that mean the start and the end posture (branch 0).
inline constexpr int kStartPosture = -1;
inline constexpr int kEndPosture = -2;

/// Time [s] that a move takes beyond its straight line, >= 0, the same both ways; infinite for a forbidden move.
/// Arguments: visit and branch at one end, visit and branch at the other.
using ExtraTime = std::function<double(int visit_a, int branch_a, int visit_b, int branch_b)>;

/// A sparse table of extra times; usable as an `ExtraTime`. Moves that it does not contain have none.
class EdgePenalties {
 public:
  /// Sets (replaces) the extra time [s] of one move, in both directions. At most 2^24 visits of 255 branches.
  void set(int visit_a, int branch_a, int visit_b, int branch_b, double seconds);
  [[nodiscard]] double operator()(int visit_a, int branch_a, int visit_b, int branch_b) const;
  [[nodiscard]] std::size_t size() const { return seconds_.size(); }
  /// Returns true if any move to or from a visit has extra time.
  [[nodiscard]] bool touches(int visit) const {
    const auto place = static_cast<std::size_t>(visit + 2);
    return place < touched_.size() && touched_[place];
  }

 private:
  std::unordered_map<std::uint64_t, double> seconds_;
  std::vector<char> touched_;  // flags by visit, so that most moves need no search
};

/// A route visits every tube once, in any order, from rest to rest. Without `start` (`end`) it begins (ends) at any
/// tube.
struct Route {
  std::vector<Visit> visits;
  JointSpeeds speeds;
  std::optional<Eigen::VectorXd> start;  ///< [rad]
  std::optional<Eigen::VectorXd> end;    ///< [rad]
  ExtraTime extra_time;                  ///< may be empty
  /// Flags by visit, nonzero if a move to or from it may have extra time. Empty: any may.
  std::vector<char> with_extra;
};

/// Returns what is wrong with the problem, one sentence each; empty if it can be solved.
[[nodiscard]] std::vector<std::string> findRouteProblems(const Route& route);

}  // namespace tubeplan::planner
