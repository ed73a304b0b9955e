// One-sentence summary of a plan: number of visited tubes, steps expected to enter, and the base for which the path is
// proved.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// Returns a sentence such as "59 of 60 tubes are visited; expected of the tool: 2 steps in 41 tubes, 3 steps in 18
/// tubes; by the true arm: 2 steps in 36 tubes, 3 steps in 23 tubes; the path is proved free for the base calibrated
/// from 3 touches."
[[nodiscard]] std::string planAnswer(const PlanOutcome& outcome);

}  // namespace tubeplan::app
