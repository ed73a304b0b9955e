// A self-contained page: one HTML file from its sources and one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/report/page_sources.hpp"

namespace tubeplan::app {

/// Kind of a page.
struct PageKind {
  std::string_view name;     ///< `page` of its document, which selects the script's sections
  std::string_view title;    ///< shown until the script sets the document's own
  std::string_view figures;  ///< place of the same figures, for readers without scripts
};

/// Returns the page with the document embedded so that no text in it can end its script block. A document that is no
/// object counts as an empty one. Bytes that are not UTF-8 become U+FFFD and numbers that are not finite become null.
/// Equal documents give equal bytes. Without a script the page says that this program has no report pictures.
[[nodiscard]] std::string renderPage(const PageKind& kind, const nlohmann::json& report,
                                     const PageSources& sources = builtPageSources());

}  // namespace tubeplan::app
