// What a campaign of centring says: JSON, a text for people, a CSV of holes, a page.
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

/// All figures but those of single holes, of which only the worst are there.
[[nodiscard]] nlohmann::json centringJson(const CentringResults& results);

/// A few lines for people, of those figures.
[[nodiscard]] std::string centringText(const nlohmann::json& figures);

/// One line for each setting, way and hole that was visited.
[[nodiscard]] std::string holesCsv(const CentringResults& results);

/// The self-contained page.
[[nodiscard]] std::string centringPage(const CentringResults& results, const nlohmann::json& figures);

}  // namespace tubeplan::app
