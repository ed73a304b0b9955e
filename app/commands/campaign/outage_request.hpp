// Validated request for a campaign of outages, in internal units.
#pragma once

#include "app/commands/campaign/centring_request.hpp"
#include "app/studies/monte_carlo/outage_trial.hpp"

namespace tubeplan::app {

struct OutageTask {
  CentringTask centring;  ///< cells, holes, and what is drawn
  OutageOptions options;
};

/// Reads the cells, finds the holes within reach and selects the changes that may be hidden. Throws InputError for bad
/// input.
[[nodiscard]] OutageTask outageTask(const CampaignRequest& request);

/// Returns a key made of everything that affects the results, except the number of runs.
[[nodiscard]] PlanKey outageKey(const OutageTask& task, const CampaignRequest& request);

}  // namespace tubeplan::app
