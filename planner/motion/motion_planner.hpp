// A free motion between two postures: straight in joint space if the straight move is proved free, else a detour that
// is found by search and shortened.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "planner/motion/motion_check.hpp"
#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

struct RoadmapWay;

/// A motion planning problem, with joint values in rad (m for a prismatic joint). A joint limit may be infinite: the
/// search then stays within half a turn beyond start and goal.
struct MotionProblem {
  Eigen::VectorXd lower, upper;
  PostureClearance clearance_of;
  TravelBound travel;
  /// Returns the cost of a straight move, such as its duration; shortening a path reduces the sum of costs. If empty,
  /// the travel bound is the cost.
  std::function<double(const Eigen::VectorXd&, const Eigen::VectorXd&)> cost;
  /// Speeds of the joints. If given, a detour is optimised and passes its waypoints without stops (flowing_timing.hpp)
  /// if that motion is proved free.
  std::optional<JointSpeeds> speeds = std::nullopt;
  /// Returns a detour from a roadmap (roadmap.hpp), tried before a search; adds the number of postures checked to
  /// `checks`.
  std::function<RoadmapWay(const Eigen::VectorXd&, const Eigen::VectorXd&, long& checks)> roadmap = {};
};

struct MotionPlannerOptions {
  std::uint64_t seed = 1;
  /// Largest number of iterations of the search; no clock is used, so that a plan depends on its seed alone.
  int max_iterations = 3000;
  double range = 0;  ///< longest step of the search, as travel [m]; 0 selects a fifth of the joint space's diagonal
  int shortcut_attempts = 100;
  int shaping_attempts = 1500;  ///< number of attempts to shape a detour with each step size
  MotionCheckOptions check = {};
};

enum class MotionPlanStatus { kNotRun, kFree, kNoPath, kStartBlocked, kGoalBlocked };

struct MotionPlan {
  MotionPlanStatus status = MotionPlanStatus::kNotRun;
  std::string reason;  ///< reason why there is no path, such as the blocking obstacle; empty if there is a path
  /// Waypoints, with start and goal included. Each straight segment between them, or the motion without stops, is
  /// proved free.
  std::vector<Eigen::VectorXd> waypoints;
  bool straight = false;  ///< true if the path consists of start and goal alone
  /// True if there is no path because the roadmap has start and goal in disconnected parts of the free space.
  bool is_disconnected = false;
  bool flows = false;  ///< true if the motion passes the waypoints without stops; that motion is then proved free
  /// Largest distance of the deflected tip from the straight line between its positions at start and goal [m]; NaN if
  /// the tip need not follow a line.
  double line_deviation = std::numeric_limits<double>::quiet_NaN();
  double cost = std::numeric_limits<double>::quiet_NaN();
  double proved_margin = std::numeric_limits<double>::quiet_NaN();  ///< smallest proved margin over all segments [m]
  /// Clearance of the tightest posture met on the path; if there is no path, of the posture that blocks the straight
  /// move.
  Clearance tightest;
  int iterations = 0;  ///< iterations of the search; 0 if none was run
  long checks = 0;     ///< number of postures checked
};

/// Sets the plan's path to the motion through the waypoints `flow` without stops, and sets its proved margin. The plan
/// has no path if any part of the motion is not proved free. The problem must have joint speeds.
void setFlowingPath(std::vector<Eigen::VectorXd> flow, const MotionProblem& problem, const MotionCheckOptions& options,
                    MotionPlan& plan);

/// Plans a motion from q0 to q1. The same problem, options and seed give bitwise identical waypoints.
[[nodiscard]] MotionPlan planMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const MotionProblem& problem,
                                    const MotionPlannerOptions& options = {});

}  // namespace tubeplan::planner
