// Self-contained pages: one HTML file made from a script, a style and one JSON document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/report/page_sources.hpp"

namespace tubeplan::app {

/// Kind of report page, such as the page of a plan or of a diagnosis.
struct PageKind {
  std::string_view name;     ///< `page` in the JSON document; selects the sections that the script shows
  std::string_view title;    ///< title of the document until the script sets it
  std::string_view figures;  ///< phrase for readers without scripts that names the place of the same results
};

/// Returns the page with the JSON document embedded so that no text in the document can end the page's script block. A
/// document that is not an object is treated as an empty object. Bytes that are not UTF-8 become U+FFFD; numbers that
/// are not finite become null. Equal documents give identical bytes. If the program was built without a script, the
/// page states that it has no pictures.
[[nodiscard]] std::string renderPage(const PageKind& kind, const nlohmann::json& report,
                                     const PageSources& sources = builtPageSources());

}  // namespace tubeplan::app
