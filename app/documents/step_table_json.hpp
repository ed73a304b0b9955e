// Step table, that is, the numbers of holes in which 0, 1, ... tool steps enter, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/units.hpp"
#include "app/studies/positioning/step_table.hpp"

namespace tubeplan::app {

/// Returns {holes, zero, one, two, three, counts, no_posture, centring_error: {median, p95}}; null if there is no
/// table.
[[nodiscard]] nlohmann::json stepTableJson(const StepTable& table, const Units& units);

}  // namespace tubeplan::app
