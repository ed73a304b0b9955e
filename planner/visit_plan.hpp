// The main task: from a work list to a proved, timed path that visits every reachable tube.
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

/// Callbacks of the planner: `progress` reports the progress of a stage, `stop` returns true to stop planning, `keep`
/// receives results to save. `progress` and `keep` are called from one thread at a time.
struct PlanHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  std::function<bool()> stop;
  std::function<void(const PlanCache& cache)> keep;
};

/// Kind of travel between the standoffs of two tubes.
enum class TravelKind {
  kJoints,  ///< straight in joint space, or a detour around obstacles
  kLine,    ///< the deflected tip stays on the line between the standoffs, if that is possible and free
};
std::string_view nameOf(TravelKind kind);  ///< name in files and options: joints or line
std::optional<TravelKind> findTravelKind(std::string_view name);

struct VisitPlanOptions {
  std::uint64_t seed = 1;
  TravelKind travel = TravelKind::kJoints;
  LineTravelOptions line;
  TubeReachOptions reach;
  VisitOrderOptions order;
  MotionPlannerOptions motion;
  VisitConditions conditions;
  int reprice_rounds = 12;           ///< largest number of rounds; each orders the visits and plans the moves
  double report_accuracy = 2.54e-4;  ///< accuracy of the reported smallest margin [m] (0.010 in)
};

enum class SegmentKind { kTravel, kApproach, kRetreat };
std::string_view nameOf(SegmentKind kind);  ///< name in files: travel, approach or retreat

/// A segment of the path, proved free. The arm moves straight in joint space and stops at every waypoint, or passes the
/// waypoints without stops.
struct PathSegment {
  SegmentKind kind = SegmentKind::kTravel;
  /// Index of the segment's visit; for a travel, of the visit that it leads to; for a travel to the end posture, of the
  /// last visit; -1 for a retreat from the start posture.
  int visit = -1;
  std::vector<Eigen::VectorXd> waypoints;
  /// Proved smallest margin beyond the clearance that the scene requires [m].
  double margin = std::numeric_limits<double>::quiet_NaN();
  Clearance tightest;
  bool flows = false;
};

struct PlannedVisit {
  int tube = -1;  ///< index of the tube in the sheet
  TubeBranch branch;
  double dwell = 0;  ///< dwell time at the hole [s]
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
  std::vector<PlannedVisit> visits;  ///< visits in the order of the path
  std::vector<UnreachableTube> unreachable;
  /// Approach, retreat, travel, approach, ...; preceded by a travel from the start posture and followed by a travel to
  /// the end posture, if these are given. If the tool is at a hole in the start posture, a retreat comes first.
  std::vector<PathSegment> segments;
  int departed = -1;  ///< index in the sheet of the hole at the start posture; -1 if there is none
  /// Time of all travels between standoffs, and from start and to end postures [s].
  double travel_time = std::numeric_limits<double>::quiet_NaN();
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< proved lower bound of `travel_time` [s]
  double optimality_gap = std::numeric_limits<double>::quiet_NaN();
  /// Travel time of straight moves in the row-by-row order [s].
  double row_by_row_time = std::numeric_limits<double>::quiet_NaN();
  /// Time of the whole path, including approaches, retreats and dwell times [s].
  double total_time = std::numeric_limits<double>::quiet_NaN();
  double min_margin = std::numeric_limits<double>::quiet_NaN();  ///< proved smallest margin over all segments [m]
  Clearance tightest;
  int detours = 0;  ///< number of travels that are neither a straight joint move nor a line
  int lines = 0;    ///< number of travels with the tip on a straight line
  /// Largest distance of the tip from the line of a straight travel [m]; NaN if there is no such travel.
  double line_deviation = std::numeric_limits<double>::quiet_NaN();
  KeptWork kept;  ///< numbers of results taken from the cache
};

/// Plans the visits of `tubes` (indices in the sheet). The same cell, work list, options and seed give the same plan,
/// for any number of threads.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes,
                                   const VisitPlanOptions& options = {}, const PlanHooks& hooks = {});

/// Plans the visits and reuses the results that are already in `cache`. The cache must belong to the same cell and
/// options and, if it has orders, to the same work list. A plan resumed after a stop is identical to the plan of an
/// uninterrupted run.
[[nodiscard]] VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                                   const PlanHooks& hooks, PlanCache& cache);

/// Returns the speed and acceleration limits of the arm's joints.
JointSpeeds jointSpeedsOf(const deflection::Arm& arm);

/// Returns the duration of a segment [s].
[[nodiscard]] double durationOf(const PathSegment& segment, const JointSpeeds& speeds);

/// Returns postures along a segment, both ends included, between which the motion is straight in joint space.
[[nodiscard]] std::vector<Eigen::VectorXd> cornersOf(const PathSegment& segment, const JointSpeeds& speeds);

/// A row of the exported path; the straight lines between consecutive rows are the motion that was proved free.
struct PathRow {
  double time = 0;  ///< time since the start of the path [s]
  int segment = 0;
  SegmentKind kind = SegmentKind::kTravel;
  Eigen::VectorXd q;
};

/// Returns the whole path as a function of time, with rows at most `max_step` [s] apart while the arm moves. A dwell
/// time at a hole gives two rows with the same posture; the second row begins the retreat.
std::vector<PathRow> samplePath(const VisitPlan& plan, const JointSpeeds& speeds, double max_step = 0.25);

}  // namespace tubeplan::planner
