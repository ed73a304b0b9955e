// A free motion between two postures: straight in joint space where that is proved free, else found by search and
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

/// Joints in rad (m for a sliding one). A limit may be infinite: then the search stays within half a turn beyond start
/// and goal.
struct MotionProblem {
  Eigen::VectorXd lower, upper;
  PostureClearance clearance_of;
  TravelBound travel;
  /// What a straight move costs (its time, say): shortening makes the sum less. The travel bound where not given.
  std::function<double(const Eigen::VectorXd&, const Eigen::VectorXd&)> cost;
  /// Where given, a way round flows through its waypoints without rest (flowing_timing.hpp) if that can be proved free,
  /// and is made quick.
  std::optional<JointSpeeds> speeds = std::nullopt;
  /// Where given, asked for a way round before one is searched for (roadmap.hpp); counts the postures it asked about.
  std::function<RoadmapWay(const Eigen::VectorXd&, const Eigen::VectorXd&, long& checks)> roadmap = {};
};

struct MotionPlannerOptions {
  std::uint64_t seed = 1;
  int max_iterations = 3000;  ///< of the search; no clock is asked, so that a plan depends on nothing but its seed
  double range = 0;           ///< m of travel, the longest step of the search; 0: a fifth of the joint space's diagonal
  int shortcut_attempts = 100;
  int shaping_attempts = 1500;  ///< at each fineness, to make a way round quick
  MotionCheckOptions check = {};
};

enum class MotionPlanStatus { kNotRun, kFree, kNoPath, kStartBlocked, kGoalBlocked };

struct MotionPlan {
  MotionPlanStatus status = MotionPlanStatus::kNotRun;
  std::string reason;  ///< what is in the way, where there is no path
  std::vector<Eigen::VectorXd>
      waypoints;          ///< start and goal included; each straight stretch between them (or the flow) is proved free
  bool straight = false;  ///< start and goal alone
  bool apart = false;     ///< no path: the ends lie in parts of the free space that the roadmap has no way between
  bool flows = false;     ///< through the waypoints without rest; what is proved free is then that flow
  /// m; most the deflected tip leaves the line between its ends, where it was to keep to it; else not a number
  double line_deviation = std::numeric_limits<double>::quiet_NaN();
  double cost = std::numeric_limits<double>::quiet_NaN();
  double proved_margin = std::numeric_limits<double>::quiet_NaN();  ///< m, least over the stretches
  Clearance tightest;  ///< the tightest posture met on the way; when there is none, what blocks the straight move
  int iterations = 0;  ///< of the search
  long checks = 0;     ///< postures asked about
};

/// Takes the flow through waypoints for the plan's way, with what is proved of it: no path where a part of it is not
/// proved free. The problem must have speeds.
void takeFlow(std::vector<Eigen::VectorXd> flow, const MotionProblem& problem, const MotionCheckOptions& options,
              MotionPlan& plan);

/// Plans from q0 to q1. Same problem, options and seed: same waypoints, to the bit.
[[nodiscard]] MotionPlan planMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const MotionProblem& problem,
                                    const MotionPlannerOptions& options = {});

}  // namespace tubeplan::planner
