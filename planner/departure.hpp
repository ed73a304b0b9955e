// Retreat from the hole in which the tool is when a plan begins. Internal to the planning of visits.
#pragma once

#include <optional>
#include <vector>

#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// A retreat straight down from the start posture.
struct Departure {
  int tube = -1;                           ///< index in the sheet of the hole that the tip leaves
  std::vector<Eigen::VectorXd> waypoints;  ///< path from the start posture to one from which the arm may travel
};

/// Returns the index of the hole that contains the point [m] in plan view; -1 if there is none.
[[nodiscard]] int holeAround(const tubesheets::Sheet& sheet, const Eigen::Vector3d& p_W);

/// Returns the retreat from the start posture to the standoff of the hole at the tip. std::nullopt if
/// there is no start posture, if the arm may travel from it at once, if the tip is at no hole, or if the retreat is not
/// clear.
[[nodiscard]] std::optional<Departure> departureFrom(const PlanContext& context);

}  // namespace tubeplan::planner
