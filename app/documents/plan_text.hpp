// A plan in words.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// The least distance along the whole path, in the internal unit of length.
[[nodiscard]] double minClearance(const PlanOutcome& outcome);

/// "link4 to divider": what is nearest there.
[[nodiscard]] std::string tightestText(const PlanOutcome& outcome);

/// The summary for one screen.
[[nodiscard]] std::string planText(const PlanRequest& request, const PlanOutcome& outcome);

}  // namespace tubeplan::app
