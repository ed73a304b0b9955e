// The page's files: those built into the program, or those of a folder while the page is worked on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/embedded_file.hpp"

namespace tubeplan::app {

/// The page's files as the program carries them; generated at build time by embed_files.cmake. Empty where the page was
/// not built.
[[nodiscard]] const std::vector<EmbeddedFile>& embeddedPage();

struct PageFile {
  std::string content, content_type;
  bool is_named_by_content = false;  ///< its name changes with it, so that a browser may keep it
};

class PageFiles {
 public:
  /// `folder`: instead of the program's own files; empty: those. Throws InputError for what is no folder.
  explicit PageFiles(const std::string& folder);

  /// The file at a path of the address ("/", "/assets/x.js"). Paths without a dot are the page itself. Nothing where
  /// there is none, or where the path leads out of the folder.
  [[nodiscard]] std::optional<PageFile> find(std::string_view path) const;

 private:
  [[nodiscard]] std::optional<std::string> contentOf(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace tubeplan::app
