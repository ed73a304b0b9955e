// The search for a detour with RRT-Connect from OMPL; this header hides the types of OMPL.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

/// For each pair of names (a body, and the obstacle or body in its way), the number of times that it blocked the
/// search.
using BlockerCounts = std::map<std::pair<std::string, std::string>, int>;

struct MotionSearchResult {
  /// Path from exactly the start to exactly the goal, each segment proved free; empty if none was found.
  std::vector<Eigen::VectorXd> waypoints;
  int iterations = 0;
  long checks = 0;  ///< number of postures checked
  BlockerCounts blockers;
};

/// Grows two trees, from the start and the goal, until they meet or all iterations are used. Start and goal must be
/// free and within the joint limits.
[[nodiscard]] MotionSearchResult searchMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                              const MotionProblem& problem, const MotionPlannerOptions& options);

}  // namespace tubeplan::planner
