// Results of a campaign of outages as JSON, as text and as a CSV table of changes. All loop over one table of figures.
#pragma once

#include "app/commands/campaign/outage_request.hpp"
#include "app/studies/monte_carlo/outage_tally.hpp"

namespace tubeplan::app {

/// Returns the results as JSON, with an entry for each change that may be hidden.
[[nodiscard]] nlohmann::json outageJson(const OutageTask& task, const CampaignRequest& request,
                                        const OutageTally& tally, const CampaignProgress& progress);

/// Returns the results as short text, from their JSON.
[[nodiscard]] std::string outageText(const nlohmann::json& figures);

/// Returns CSV with one line for each change, from the JSON.
[[nodiscard]] std::string changesCsv(const nlohmann::json& figures);

}  // namespace tubeplan::app
