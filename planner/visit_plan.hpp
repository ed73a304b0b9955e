// The main job: from a work list to a proved, timed path that visits every reachable tube.
//
// Example, compiled and run by tests/examples:
//
//     #include "planner/visit_plan.hpp"
//     using namespace tubeplan;
//     planner::Workcell cell;  // a gantry of three slides under a small sheet
//     cell.sheet = tubesheets::makeSheet(
//         {"small", {.type = "square", .pitch = 0.025, .first_row = 0.05, .radius = 0.2}, 0.019});
//     cell.X_WB.translation() = Eigen::Vector3d(0, 0, -0.5);
//     const double right = 1.5707963267948966;
//     for (const Eigen::Vector3d& rpy : {Eigen::Vector3d(0, right, 0), Eigen::Vector3d(-right, 0, 0),
//                                        Eigen::Vector3d(0, -right, 0)}) {
//       auto& row = cell.arm.rows.emplace_back();
//       row.name = "slide" + std::to_string(cell.arm.rows.size());
//       row.placement = deflection::Origin<double>{{0, 0, 0}, rpy};
//       row.joint = {.name = row.name, .type = deflection::JointType::kPrismatic,
//                    .lower = -1, .upper = 1, .max_speed = 0.1, .max_acceleration = 0.5};
//       cell.scene.links.push_back({row.name});
//     }
//     const auto plan = planner::planVisits(cell, {0, 5, 20, 40});
//     std::printf("%zu tubes in %.1f s\n", plan.visits.size(), plan.total_time);  // prints 4 tubes in 8.7 s
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/motion/motion_planner.hpp"
#include "planner/order/visit_order.hpp"
#include "planner/plan_cache.hpp"
#include "planner/reach/line_travel.hpp"
#include "planner/reach/tube_reach.hpp"
#include "planner/timing/trapezoid_timing.hpp"
#include "planner/visit_conditions.hpp"

namespace tubeplan::planner {

/// Told how much of a stage is done; asked whether to stop; shown what there is to keep. `progress` and `keep` are
/// called by one thread at a time.
struct PlanHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  std::function<bool()> stop;
  std::function<void(const PlanCache& cache)> keep;
};

/// How the tool goes from tube to tube.
enum class TravelKind {
  kJoints,  ///< straight in joint space, or round what is in the way
  kLine,    ///< the deflected tip on the line between the standoffs, where that is possible and free
};
std::string_view nameOf(TravelKind kind);  ///< joints, line
std::optional<TravelKind> findTravelKind(std::string_view name);

struct VisitPlanOptions {
  std::uint64_t seed = 1;
  TravelKind travel = TravelKind::kJoints;
  LineTravelOptions line;
  TubeReachOptions reach;
  VisitOrderOptions order;
  MotionPlannerOptions motion;
  VisitConditions conditions;
  int reprice_rounds = 12;           ///< order, plan the chosen moves, put their true times in, order again
  double report_accuracy = 2.54e-4;  ///< m, of the least clearance that is reported (0.010 in)
};

enum class SegmentKind { kTravel, kApproach, kRetreat };
std::string_view nameOf(SegmentKind kind);  ///< travel, approach, retreat

/// One stretch of the path: the arm rests at every waypoint and moves straight in joint space between them, or flows
/// through them; proved free.
struct PathSegment {
  SegmentKind kind = SegmentKind::kTravel;
  int visit = -1;  ///< the visit it belongs to (a travel: the one it leads to; to the end posture: the last)
  std::vector<Eigen::VectorXd> waypoints;
  double margin =
      std::numeric_limits<double>::quiet_NaN();  ///< m, proved, beyond the clearance that the scene asks for
  Clearance tightest;
  bool flows = false;
};

struct PlannedVisit {
  int tube = -1;  ///< index in the sheet
  TubeBranch branch;
  double dwell = 0;  ///< s at the hole
};

struct UnreachableTube {
  int tube = -1;
  std::string reason;
  Clearance blocking;
};

enum class VisitPlanStatus { kNotRun, kPlanned, kNothingReachable, kNoOrder, kStopped };

struct VisitPlan {
  VisitPlanStatus status = VisitPlanStatus::kNotRun;
  std::string reason;
  std::vector<PlannedVisit> visits;  ///< in visiting order
  std::vector<UnreachableTube> unreachable;
  /// Approach, retreat, travel, approach, ...; before and after them the travels from the start and to the end posture.
  std::vector<PathSegment> segments;
  double travel_time = std::numeric_limits<double>::quiet_NaN();  ///< s, between the standoffs, start and end postures
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< s, proved, of the same
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();
  double row_by_row_time = std::numeric_limits<double>::quiet_NaN();  ///< s, straight moves row after row
  double total_time = std::numeric_limits<double>::quiet_NaN();       ///< s, approaches, retreats and stays included
  double min_margin = std::numeric_limits<double>::quiet_NaN();       ///< m, proved, over all segments
  Clearance tightest;
  int detours = 0;  ///< travels that are neither a straight joint move nor a line
  int lines = 0;    ///< travels with the tip on a line
  double line_deviation = std::numeric_limits<double>::quiet_NaN();  ///< m, most a tip leaves its line
  KeptWork kept;                                                     ///< what the memory had already
};

/// Plans the visit of `tubes` (indices in the sheet). Same cell, list, options and seed: same plan, at any number of
/// threads.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes,
                                   const VisitPlanOptions& options = {}, const PlanHooks& hooks = {});

/// The same with a memory, which must be of the same cell and options and, where it has orders, of the same list; what
/// it has is not worked out again. Taken up after a stop, wherever that was, it gives the plan of a run without one.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                                   const PlanHooks& hooks, PlanCache& cache);

/// Speed and acceleration limits of the arm's joints.
JointSpeeds jointSpeedsOf(const deflection::Arm& arm);

/// How long a segment takes [s].
[[nodiscard]] double durationOf(const PathSegment& segment, const JointSpeeds& speeds);

/// The postures between which a segment runs straight.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const PathSegment& segment, const JointSpeeds& speeds);

/// One row of the exported path; straight between rows is the motion that was proved free.
struct PathRow {
  double time = 0;  ///< s
  int segment = 0;
  SegmentKind kind = SegmentKind::kTravel;
  Eigen::VectorXd q;
};

/// The whole path in time, rows at most `max_step` seconds apart while the arm moves. A stay at a hole is two rows with
/// the same posture; the second begins the retreat.
std::vector<PathRow> samplePath(const VisitPlan& plan, const JointSpeeds& speeds, double max_step = 0.25);

}  // namespace tubeplan::planner
