// A file embedded in the program.
#pragma once

#include <string_view>

namespace tubeplan::app {

struct EmbeddedFile {
  std::string_view path;  ///< path within the embedded folder: "index.html", "assets/index-1a2b.js", "report.js"
  std::string_view content;
};

}  // namespace tubeplan::app
