// A self-contained page: one HTML file from its sources and one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/report/page_sources.hpp"

namespace tubeplan::app {

/// What a page is of.
struct PageKind {
  std::string_view name;     ///< `page` of its document, by which the script knows its sections
  std::string_view title;    ///< until the script puts the document's own
  std::string_view figures;  ///< where the same figures are, for who allows no scripts
};

/// The page with the document embedded so that no text in it can end its script block; what is no object counts as an
/// empty one. Bytes that are not UTF-8 become U+FFFD and numbers that are not finite become null. Same document, same
/// bytes. Without a script the page says that this program has no report pictures.
[[nodiscard]] std::string renderPage(const PageKind& kind, const nlohmann::json& report,
                                     const PageSources& sources = builtPageSources());

}  // namespace tubeplan::app
