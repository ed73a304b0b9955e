// Script and style of report pages, built from app/web and embedded in the program.
#pragma once

#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// Returns the files of the report's script and style, which embed_files.cmake generates at build time; empty if the
/// program was built without the page.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedReport();

struct PageSources {
  std::string_view style, script;  ///< ASCII text that cannot end its `<style>` or `<script>` block
};

/// Returns the script and the style, which are found among embeddedReport() by file name.
[[nodiscard]] PageSources builtPageSources();

}  // namespace tubeplan::app
