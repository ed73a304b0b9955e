// Pages of `tubeplan job`: the hand-over of a shift, and the plan of a job.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tubeplan::app {

/// Returns the page of `tubeplan job report`. `report` is handOverJson() with `version`. Markup in strings is harmless,
/// as in renderPage(). Every part may be absent or null; the page then states that it is missing.
[[nodiscard]] std::string renderHandOverReport(const nlohmann::json& report);

/// Returns the page of `tubeplan job plan`. `report` is {title, version, plan: jobPlanJson()}. Missing parts and markup
/// are handled as in renderHandOverReport().
[[nodiscard]] std::string renderJobPlanReport(const nlohmann::json& report);

}  // namespace tubeplan::app
