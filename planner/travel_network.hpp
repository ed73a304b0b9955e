// The travels between standoffs: planned only when an order asks for them, and kept in the plan's memory.
#pragma once

#include <map>
#include <optional>

#include "planner/motion/roadmap.hpp"
#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// A visit's place in the order, as a posture to travel from or to; or the start or the end posture, branch 0.
struct Stop {
  int visit, branch;
  auto operator<=>(const Stop&) const = default;
};

/// What a travel through a cell is asked of.
[[nodiscard]] MotionProblem travelProblemOf(const PlanContext& context);

/// The cell's roadmap, made when it is first asked for. Its postures are where tubes all over the sheet are approached
/// from, whatever the list, and random ones.
class TravelRoadmap {
 public:
  explicit TravelRoadmap(const PlanContext& context) : context_(context) {}
  const Roadmap& get();

  /// Searches ways between the parts that these postures lie in (Roadmap::bridge). Travels that had no way for want of
  /// one are then planned anew, though not remembered, so that a plan that is resumed goes the same way.
  bool bridge(const std::vector<Eigen::VectorXd>& postures);
  [[nodiscard]] bool isBridged() const { return is_bridged_; }
  [[nodiscard]] std::map<MotionEnds, MotionPlan>& rejoined() { return rejoined_; }

 private:
  const PlanContext& context_;
  std::optional<Roadmap> roadmap_;
  bool is_bridged_ = false;
  std::map<MotionEnds, MotionPlan> rejoined_;
};

/// What a travel will take, before it is planned in full.
struct TravelEstimate {
  double time = std::numeric_limits<double>::infinity();  ///< s; infinite where there is no way
  bool is_exact = false;                                  ///< else of a way that is yet to be made quick
  bool apart = false;                                     ///< as of the motion's plan, with what is in the way of it
  Clearance tightest;
  long checks = 0;  ///< postures asked about
};

class TravelNetwork {
 public:
  TravelNetwork(const PlanContext& context, const std::vector<TubeReach>& reach, TravelRoadmap& roadmap);

  /// The travel from one stop to another, planned the first time it is asked for (or its reverse).
  const MotionPlan& between(Stop a, Stop b);

  /// Found in a fraction of the time, and not remembered; what the memory has makes no difference to it.
  [[nodiscard]] TravelEstimate estimate(Stop a, Stop b);

  /// The part of the free space that each stop lies in (Roadmap::partsOf).
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
  std::optional<LineTravels> lines_;           ///< where the tool is to go straight
  std::map<MotionEnds, MotionPlan> backward_;  ///< the greater end first
};

}  // namespace tubeplan::planner
