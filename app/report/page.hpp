// A self-contained page: one HTML file from its sources and one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/report/page_sources.hpp"

namespace tubeplan::app {

/// The sources with the data embedded so that no text in it can end its script block. Bytes that are not UTF-8 become
/// U+FFFD and numbers that are not finite become null. Same document, same bytes.
[[nodiscard]] std::string renderPage(const PageSources& sources, const nlohmann::json& report);

}  // namespace tubeplan::app
