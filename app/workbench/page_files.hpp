// Files of the page: those built into the program, or those of a folder during development of the page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// Returns the page's files in the program, generated at build time by embed_files.cmake. Empty if the page was not
/// built.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedPage();

struct PageFile {
  std::string content, content_type;
  bool is_named_by_content = false;  ///< true if its name changes with its content, so that a browser may cache it
};

class PageFiles {
 public:
  /// Serves the files of `folder`; empty: the program's own files. Throws InputError if it is not a folder.
  explicit PageFiles(const std::string& folder);

  /// Returns the file at a path of the address ("/", "/assets/x.js"). Paths without a dot give the page itself. Returns
  /// nullopt if there is none, or if the path leads out of the folder.
  [[nodiscard]] std::optional<PageFile> find(std::string_view path) const;

 private:
  [[nodiscard]] std::optional<std::string> contentOf(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace tubeplan::app
