// What a report is drawn with: built of app/web, and carried by the program.
#pragma once

#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// The report's script and style; generated at build time by embed_files.cmake. Empty where the page was not built.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedReport();

struct PageSources {
  std::string_view style, script;  ///< ASCII; nothing in them ends its block of the page
};

/// The program's own, by their names in embeddedReport().
[[nodiscard]] PageSources builtPageSources();

}  // namespace tubeplan::app
