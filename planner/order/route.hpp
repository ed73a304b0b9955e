// The ordering problem: tubes to visit, the postures (branches) that reach each tube, and the time of a move between
// two postures.
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

/// A tube to visit, with one or more postures that reach it [rad].
struct Visit {
  std::vector<Eigen::VectorXd> branches;
};

/// Visit indices that represent the start and the end posture (branch 0).
inline constexpr int kStartPosture = -1;
inline constexpr int kEndPosture = -2;

/// Time [s] that a move takes in addition to its straight line: zero or more, equal in both directions, infinite for a
/// forbidden move. Arguments: visit and branch at one end, visit and branch at the other end.
using ExtraTime = std::function<double(int visit_a, int branch_a, int visit_b, int branch_b)>;

/// A sparse table of extra times; usable as an `ExtraTime`. Moves that the table does not contain have no extra time.
class EdgePenalties {
 public:
  /// Sets or replaces the extra time [s] of one move, in both directions. At most 2^24 visits with 255 branches each.
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
  std::vector<char> touched_;  // for each visit, nonzero if any of its moves has extra time; avoids most look-ups
};

/// Ordering problem: visit every tube once, in any order, starting and ending at rest. Without `start` it begins at any
/// tube; without `end` it ends at any tube.
struct Route {
  std::vector<Visit> visits;
  JointSpeeds speeds;
  std::optional<Eigen::VectorXd> start;  ///< start posture [rad]; the route may begin at any tube if there is none
  std::optional<Eigen::VectorXd> end;    ///< end posture [rad]; the route may end at any tube if there is none
  ExtraTime extra_time;                  ///< extra times of moves; empty if no move has extra time
  /// Flag for each visit, nonzero if a move to or from it may have extra time. Empty means that any move may.
  std::vector<char> with_extra;
};

/// Returns the problems of a route, one sentence each; empty if it can be solved.
[[nodiscard]] std::vector<std::string> findRouteProblems(const Route& route);

}  // namespace tubeplan::planner
