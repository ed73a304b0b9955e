// Script and style of reports: built from app/web, and embedded in the program.
#pragma once

#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// Returns the report's script and style; generated at build time by embed_files.cmake. Empty if the page was not
/// built.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedReport();

struct PageSources {
  std::string_view style, script;  ///< ASCII; nothing in them ends its block of the page
};

/// Returns the program's own sources, by their names in embeddedReport().
[[nodiscard]] PageSources builtPageSources();

}  // namespace tubeplan::app
