// The travels between standoffs: planned only when an order asks for them, and remembered.
#pragma once

#include <array>
#include <map>

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// A visit's place in the order, as a posture to travel from or to.
struct Stop {
  int visit, branch;
  auto operator<=>(const Stop&) const = default;
};

class TravelNetwork {
 public:
  TravelNetwork(const ArmClearance& clearance, const std::vector<TubeReach>& reach, const JointSpeeds& speeds,
                const VisitPlanOptions& options);

  /// The travel from one stop to another, planned the first time it is asked for (or its reverse).
  const MotionPlan& between(Stop a, Stop b);

  [[nodiscard]] bool knows(Stop a, Stop b) const;
  [[nodiscard]] const Eigen::VectorXd& standoff(Stop stop) const;
  [[nodiscard]] double timeOf(const MotionPlan& plan) const;

 private:
  const ArmClearance& clearance_;
  const std::vector<TubeReach>& reach_;
  const JointSpeeds& speeds_;
  const VisitPlanOptions& options_;
  MotionProblem problem_;
  std::map<std::pair<Stop, Stop>, MotionPlan> plans_;
};

}  // namespace tubeplan::planner
