// Page of `tubeplan campaign`: one self-contained HTML file made from one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the page for the content of campaign.json with a `title` and, for a campaign of centring, also
///   sheet: as for renderPlanReport()
///   maps: [{setting, way, holes: [[row, column, x, y, visits, mean, [[chance, low, high], ...]], ...]}, ...]
/// Markup in strings is harmless, as in renderPage(). Every part may be absent or null; the page then states that it is
/// missing.
[[nodiscard]] std::string renderCampaignReport(const nlohmann::json& report);

}  // namespace tubeplan::app
