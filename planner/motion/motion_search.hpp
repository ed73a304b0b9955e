// The search for a way round, by OMPL's RRT-Connect; its types stay behind this header.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

/// How often each pair of names was in the way.
using BlockerCounts = std::map<std::pair<std::string, std::string>, int>;

struct MotionSearchResult {
  std::vector<Eigen::VectorXd>
      waypoints;  ///< empty: none found; else from start to goal exactly, each stretch proved free
  int iterations = 0;
  long checks = 0;  ///< postures asked about
  BlockerCounts blockers;
};

/// Grows two trees from start and goal until they meet or the iterations are spent. Both ends must be free and within
/// limits.
[[nodiscard]] MotionSearchResult searchMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                              const MotionProblem& problem, const MotionPlannerOptions& options);

}  // namespace tubeplan::planner
