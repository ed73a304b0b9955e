// Results of a centring campaign as JSON, as text, as a CSV table of holes and as a page.
#pragma once

#include "app/commands/campaign/centring_request.hpp"
#include "app/studies/monte_carlo/centring_tally.hpp"

namespace tubeplan::app {

struct CentringResults {
  const CentringTask& task;
  const CampaignRequest& request;
  const CentringTrials& trials;
  const CentringTally& tally;
  CampaignProgress progress;
};

/// Returns the results as JSON, with separate entries only for the holes with the largest errors.
[[nodiscard]] nlohmann::json centringJson(const CentringResults& results);

/// Returns the results as short text, from their JSON.
[[nodiscard]] std::string centringText(const nlohmann::json& figures);

/// Returns CSV with one line for each combination of setting, compensation method and visited hole.
[[nodiscard]] std::string holesCsv(const CentringResults& results);

/// Returns the campaign's self-contained HTML page.
[[nodiscard]] std::string centringPage(const CentringResults& results, const nlohmann::json& figures);

}  // namespace tubeplan::app
