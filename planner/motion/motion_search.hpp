// The search for a detour, by OMPL's RRT-Connect; this header hides its types.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

/// Number of times that each pair of names was in the way.
using BlockerCounts = std::map<std::pair<std::string, std::string>, int>;

struct MotionSearchResult {
  /// Path from start to goal exactly, each stretch proved free; empty if none was found.
  std::vector<Eigen::VectorXd> waypoints;
  int iterations = 0;
  long checks = 0;  ///< number of postures checked
  BlockerCounts blockers;
};

/// Grows two trees from start and goal until they meet or the iterations are used up. Both ends must be free and within
/// limits.
[[nodiscard]] MotionSearchResult searchMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                              const MotionProblem& problem, const MotionPlannerOptions& options);

}  // namespace tubeplan::planner
