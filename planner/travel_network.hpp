// The travels between standoffs: planned only when an order asks for them, and kept in the plan's memory.
#pragma once

#include <map>
#include <optional>

#include "planner/motion/roadmap.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// A visit's place in the order, as a posture to travel from or to; or the start or the end posture, branch 0.
struct Stop {
  int visit, branch;
  auto operator<=>(const Stop&) const = default;
};

/// What a travel through a cell is asked of.
[[nodiscard]] MotionProblem travelProblemOf(const ArmClearance& clearance, const VisitPlanOptions& options);

/// The cell's roadmap, made when it is first asked for. Its postures are where tubes all over the sheet are approached
/// from, whatever the list, and random ones.
class TravelRoadmap {
 public:
  TravelRoadmap(const ArmClearance& clearance, const VisitPlanOptions& options)
      : clearance_(clearance), options_(options) {}
  const Roadmap& get();

 private:
  const ArmClearance& clearance_;
  const VisitPlanOptions& options_;
  std::optional<Roadmap> roadmap_;
};

class TravelNetwork {
 public:
  TravelNetwork(const ArmClearance& clearance, const std::vector<TubeReach>& reach, TravelRoadmap& roadmap,
                const VisitPlanOptions& options, PlanCache& cache);

  /// The travel from one stop to another, planned the first time it is asked for (or its reverse).
  const MotionPlan& between(Stop a, Stop b);

  [[nodiscard]] TubePosture postureOf(Stop stop) const;
  [[nodiscard]] const Eigen::VectorXd& standoff(Stop stop) const;
  [[nodiscard]] double timeOf(const MotionPlan& plan) const;
  [[nodiscard]] const deflection::Arm& arm() const { return clearance_.cell().arm; }

 private:
  [[nodiscard]] MotionPlan onLine(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);
  [[nodiscard]] MotionPlan planned(Stop a, Stop b);

  const ArmClearance& clearance_;
  const std::vector<TubeReach>& reach_;
  const JointSpeeds speeds_;
  const VisitPlanOptions& options_;
  PlanCache& cache_;
  MotionProblem problem_;
  std::optional<LineTravels> lines_;           ///< where the tool is to go straight
  std::map<MotionEnds, MotionPlan> backward_;  ///< the greater end first
};

}  // namespace tubeplan::planner
