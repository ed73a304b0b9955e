// A free motion between two postures: straight in joint space if that is proved free, else found by search and
// shortened.
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

/// Motion problem, with joints in rad (m for a sliding one). A limit may be infinite: the search then stays within half
/// a turn beyond start and goal.
struct MotionProblem {
  Eigen::VectorXd lower, upper;
  PostureClearance clearance_of;
  TravelBound travel;
  /// Cost of a straight move, such as its time; shortening reduces the sum. If empty, the travel bound.
  std::function<double(const Eigen::VectorXd&, const Eigen::VectorXd&)> cost;
  /// Speeds of the joints. If given, a detour flows through its waypoints without stops (flowing_timing.hpp), if that
  /// can be proved free, and is optimised.
  std::optional<JointSpeeds> speeds = std::nullopt;
  /// Source of detours that is tried before a search (roadmap.hpp); counts the postures checked.
  std::function<RoadmapWay(const Eigen::VectorXd&, const Eigen::VectorXd&, long& checks)> roadmap = {};
};

struct MotionPlannerOptions {
  std::uint64_t seed = 1;
  int max_iterations = 3000;  ///< iterations of the search; no clock is used, so that a plan depends on its seed alone
  double range = 0;           ///< longest step of the search, as travel [m]; 0: a fifth of the joint space's diagonal
  int shortcut_attempts = 100;
  int shaping_attempts = 1500;  ///< attempts per step size to optimise a detour
  MotionCheckOptions check = {};
};

enum class MotionPlanStatus { kNotRun, kFree, kNoPath, kStartBlocked, kGoalBlocked };

struct MotionPlan {
  MotionPlanStatus status = MotionPlanStatus::kNotRun;
  std::string reason;  ///< obstacle in the way, if there is no path
  /// Start and goal included; each straight stretch between them (or the flow) is proved free.
  std::vector<Eigen::VectorXd> waypoints;
  bool straight = false;  ///< true: start and goal alone
  /// True: no path, because the ends lie in parts of the free space that the roadmap does not connect.
  bool apart = false;
  bool flows = false;  ///< true: passes the waypoints without stops; that flow is then proved free
  /// largest distance of the deflected tip from the line between its ends, if it had to follow it; else NaN [m]
  double line_deviation = std::numeric_limits<double>::quiet_NaN();
  double cost = std::numeric_limits<double>::quiet_NaN();
  double proved_margin = std::numeric_limits<double>::quiet_NaN();  ///< least over the stretches [m]
  Clearance tightest;  ///< the tightest posture met on the path; if there is none, what blocks the straight move
  int iterations = 0;  ///< iterations of the search
  long checks = 0;     ///< number of postures checked
};

/// Makes the flow through waypoints the plan's path, with its proved margin; no path if a part of it is not proved
/// free. The problem must have speeds.
void takeFlow(std::vector<Eigen::VectorXd> flow, const MotionProblem& problem, const MotionCheckOptions& options,
              MotionPlan& plan);

/// Plans from q0 to q1. The same problem, options and seed give the same waypoints, to the bit.
[[nodiscard]] MotionPlan planMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const MotionProblem& problem,
                                    const MotionPlannerOptions& options = {});

}  // namespace tubeplan::planner
