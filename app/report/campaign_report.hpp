// The page of `tubeplan campaign`, one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the page, from campaign.json with title, and for a campaign of centring
///   sheet: as renderPlanReport() takes it
///   maps: [{setting, way, holes: [[row, column, x, y, visits, mean, [[chance, low, high], ...]], ...]}, ...]
/// Safe for hostile text as renderPage(). Every part may be absent or null; the page then says so there.
[[nodiscard]] std::string renderCampaignReport(const nlohmann::json& report);

}  // namespace tubeplan::app
