// Travels between standoffs, planned on demand and stored in the plan's cache.
#pragma once

#include <map>
#include <optional>

#include "planner/motion/roadmap.hpp"
#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// One end of a travel: a visit with the index of its branch, or the start or end posture with branch 0.
struct Stop {
  int visit, branch;
  auto operator<=>(const Stop&) const = default;
};

/// Returns the motion planning problem for travels between standoffs in the cell.
[[nodiscard]] MotionProblem travelProblemOf(const PlanContext& context);

/// The cell's roadmap, built on first use. Its postures are standoffs of tubes all over the sheet, independent of the
/// work list, and random postures.
class TravelRoadmap {
 public:
  explicit TravelRoadmap(const PlanContext& context) : context_(context) {}
  const Roadmap& get();

  /// Searches for connections between the parts of the free space that contain these postures (Roadmap::bridge()).
  /// Travels that had failed for lack of a connection are then planned again. Their new results are not cached, so that
  /// a resumed plan repeats the same steps.
  bool bridge(const std::vector<Eigen::VectorXd>& postures);
  [[nodiscard]] bool isBridged() const { return is_bridged_; }
  [[nodiscard]] std::map<MotionEnds, MotionPlan>& rejoined() { return rejoined_; }

 private:
  const PlanContext& context_;
  std::optional<Roadmap> roadmap_;
  bool is_bridged_ = false;
  std::map<MotionEnds, MotionPlan> rejoined_;
};

/// Estimated time of a travel, before the travel is planned in full.
struct TravelEstimate {
  double time = std::numeric_limits<double>::infinity();  ///< time of the travel [s]; infinite if there is no path
  bool is_exact = false;  ///< true if the time is final; false for a detour that is not yet optimised
  /// True if there is no path because the ends are disconnected; `tightest` then has the obstacle.
  bool is_disconnected = false;
  Clearance tightest;
  long checks = 0;  ///< number of postures checked
};

class TravelNetwork {
 public:
  TravelNetwork(const PlanContext& context, const std::vector<TubeReach>& reach, TravelRoadmap& roadmap);

  /// Returns the motion from one stop to another. A motion is planned the first time it or its reverse is requested.
  const MotionPlan& between(Stop a, Stop b);

  /// Returns an estimate of a travel at a fraction of the cost of planning it. The estimate is not cached, and does not
  /// depend on the cache.
  [[nodiscard]] TravelEstimate estimate(Stop a, Stop b);

  /// For each stop, returns the number of the part of the free space that it lies in (Roadmap::partsOf()).
  [[nodiscard]] std::vector<int> partsOf(const std::vector<Stop>& stops);

  [[nodiscard]] TubePosture postureOf(Stop stop) const;
  [[nodiscard]] const Eigen::VectorXd& standoff(Stop stop) const;
  [[nodiscard]] double timeOf(const MotionPlan& plan) const;

 private:
  [[nodiscard]] MotionPlan onLine(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);
  [[nodiscard]] MotionPlan planned(Stop a, Stop b, int shaping_attempts);
  [[nodiscard]] MotionPlan planned(Stop a, Stop b);

  const MotionPlan& forward(Stop a, Stop b);

  const PlanContext& context_;
  const std::vector<TubeReach>& reach_;
  TravelRoadmap& roadmap_;
  MotionProblem problem_;
  std::optional<LineTravels> lines_;           ///< straight travels of the tool; empty unless the options request them
  std::map<MotionEnds, MotionPlan> backward_;  ///< reversed travels, keyed by their ends with the larger end first
};

}  // namespace tubeplan::planner
