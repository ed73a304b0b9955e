// Maps of a job's legs as a JSON document: the standing of each hole's items, and the remaining work on each leg.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/outage/job_store.hpp"

namespace tubeplan::app {

/// Returns [{leg, COUNTS as in totalsJson(), to_visit, time_left_s or null, sheet, standings: [{package, of}]}], one
/// entry for each leg with items. `plan` is as jobPlanJson() returned it, or null. `sheet` is as in sheetPageJson();
/// `of` has one letter for each hole. The first entry of `standings`, without a package, has the most urgent standing
/// of all packages.
[[nodiscard]] nlohmann::json legMapsJson(JobStore& store, const nlohmann::json& plan);

/// Returns [{letter, name}]: the standings, the most urgent first.
[[nodiscard]] nlohmann::json standingLettersJson();

}  // namespace tubeplan::app
