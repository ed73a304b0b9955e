// Results of a campaign of centring: JSON, a text for people, a CSV of holes, a page.
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

/// Returns all figures except those of single holes, of which only the worst are included.
[[nodiscard]] nlohmann::json centringJson(const CentringResults& results);

/// Returns the figures as a short text.
[[nodiscard]] std::string centringText(const nlohmann::json& figures);

/// Returns one line for each setting, way and visited hole.
[[nodiscard]] std::string holesCsv(const CentringResults& results);

/// Returns the self-contained page.
[[nodiscard]] std::string centringPage(const CentringResults& results, const nlohmann::json& figures);

}  // namespace tubeplan::app
