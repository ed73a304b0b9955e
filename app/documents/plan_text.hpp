// Summary of a plan as text for the terminal.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// Returns the smallest distance between arm and obstacles along the whole path [m].
[[nodiscard]] double minClearance(const PlanOutcome& outcome);

/// Returns the pair of bodies with the smallest distance along the path, such as "link4 to divider".
[[nodiscard]] std::string tightestText(const PlanOutcome& outcome);

/// Returns the parts reused of an earlier plan: "the reach of 4 of 6 tubes, 3 of 5 travels, 7 of 11 proofs, the order".
[[nodiscard]] std::string reusedText(const PlanOutcome& outcome);

/// Returns a summary of the plan that fits on one screen.
[[nodiscard]] std::string planText(const PlanRequest& request, const PlanOutcome& outcome);

}  // namespace tubeplan::app
