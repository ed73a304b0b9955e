// Plan in words.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// Returns the least distance along the whole path [m].
[[nodiscard]] double minClearance(const PlanOutcome& outcome);

/// Returns the nearest pair at the least distance: "link4 to divider".
[[nodiscard]] std::string tightestText(const PlanOutcome& outcome);

/// Returns the summary for one screen.
[[nodiscard]] std::string planText(const PlanRequest& request, const PlanOutcome& outcome);

}  // namespace tubeplan::app
