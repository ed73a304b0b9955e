// Files of the page: built into the program, or read from a folder during development of the page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// Returns the files of the page that are built into the program, as embed_files.cmake generates them. Empty if the
/// page was not built.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedPage();

struct PageFile {
  std::string content, content_type;
  bool is_named_by_content = false;  ///< true if the name changes with the content, so that browsers may cache the file
};

class PageFiles {
 public:
  /// Serves the files of `folder`, or the files built into the program if it is empty. Throws InputError if `folder` is
  /// not a folder.
  explicit PageFiles(const std::string& folder);

  /// Returns the file at a URL path ("/", "/assets/x.js"). A path without a dot returns the page itself. Returns
  /// nullopt if the file is missing or the path leads out of the folder.
  [[nodiscard]] std::optional<PageFile> find(std::string_view path) const;

 private:
  [[nodiscard]] std::optional<std::string> contentOf(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace tubeplan::app
