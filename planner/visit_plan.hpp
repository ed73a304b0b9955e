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

/// Callbacks of a plan: progress of a stage, question whether to stop, results to keep. `progress` and `keep` are
/// called by one thread at a time.
struct PlanHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  std::function<bool()> stop;
  std::function<void(const PlanCache& cache)> keep;
};

/// Kind of travel from tube to tube.
enum class TravelKind {
  kJoints,  ///< straight in joint space, or round obstacles
  kLine,    ///< the deflected tip on the line between the standoffs, if that is possible and free
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
  int reprice_rounds = 12;           ///< rounds of ordering, planning the chosen moves and setting their true times
  double report_accuracy = 2.54e-4;  ///< accuracy of the reported least clearance [m] (0.010 in)
};

enum class SegmentKind { kTravel, kApproach, kRetreat };
std::string_view nameOf(SegmentKind kind);  ///< travel, approach, retreat

/// A stretch of the path, proved free: the arm stops at every waypoint and moves straight in joint space between them,
/// or flows through them.
struct PathSegment {
  SegmentKind kind = SegmentKind::kTravel;
  int visit = -1;  ///< visit that it belongs to (a travel: the one it leads to; to the end posture: the last)
  std::vector<Eigen::VectorXd> waypoints;
  /// Proved least margin beyond the clearance that the scene requires [m].
  double margin = std::numeric_limits<double>::quiet_NaN();
  Clearance tightest;
  bool flows = false;
};

struct PlannedVisit {
  int tube = -1;  ///< index in the sheet
  TubeBranch branch;
  double dwell = 0;  ///< stay at the hole [s]
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
  std::vector<PlannedVisit> visits;  ///< visits in visiting order
  std::vector<UnreachableTube> unreachable;
  /// Approach, retreat, travel, approach, ...; before and after them the travels from the start and to the end posture.
  std::vector<PathSegment> segments;
  double travel_time = std::numeric_limits<double>::quiet_NaN();  ///< between the standoffs, start and end postures [s]
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< proved lower bound of `travel_time` [s]
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();
  double row_by_row_time = std::numeric_limits<double>::quiet_NaN();  ///< straight moves row after row [s]
  double total_time = std::numeric_limits<double>::quiet_NaN();       ///< approaches, retreats and stays included [s]
  double min_margin = std::numeric_limits<double>::quiet_NaN();       ///< proved least margin over all segments [m]
  Clearance tightest;
  int detours = 0;  ///< travels that are neither a straight joint move nor a line
  int lines = 0;    ///< travels with the tip on a line
  double line_deviation = std::numeric_limits<double>::quiet_NaN();  ///< largest distance of a tip from its line [m]
  KeptWork kept;                                                     ///< numbers of results taken from the cache
};

/// Plans the visit of `tubes` (indices in the sheet). The same cell, list, options and seed give the same plan, for any
/// number of threads.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes,
                                   const VisitPlanOptions& options = {}, const PlanHooks& hooks = {});

/// Plans with a cache, which must be of the same cell and options and, if it has orders, of the same list; its results
/// are not computed again. A plan resumed after a stop is equal to that of an uninterrupted run.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                                   const PlanHooks& hooks, PlanCache& cache);

/// Returns the speed and acceleration limits of the arm's joints.
JointSpeeds jointSpeedsOf(const deflection::Arm& arm);

/// Returns the duration of a segment [s].
[[nodiscard]] double durationOf(const PathSegment& segment, const JointSpeeds& speeds);

/// Returns the postures between which a segment is straight.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const PathSegment& segment, const JointSpeeds& speeds);

/// A row of the exported path; straight lines between rows are the motion that was proved free.
struct PathRow {
  double time = 0;  ///< [s]
  int segment = 0;
  SegmentKind kind = SegmentKind::kTravel;
  Eigen::VectorXd q;
};

/// Returns the whole path in time, with rows at most `max_step` seconds apart while the arm moves. A stay at a hole is
/// two rows with the same posture; the second begins the retreat.
std::vector<PathRow> samplePath(const VisitPlan& plan, const JointSpeeds& speeds, double max_step = 0.25);

}  // namespace tubeplan::planner
