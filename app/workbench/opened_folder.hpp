// Single folder whose files the workbench may read and write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tubeplan::app {

class OpenedFolder {
 public:
  /// Opens a folder. Throws InputError if it is not a folder.
  explicit OpenedFolder(const std::filesystem::path& folder);

  /// Returns the canonical path of an existing file by its plain name. Throws InputError for a name with folders in it,
  /// a hidden one, and one that leads out of the folder (a symbolic link).
  [[nodiscard]] std::filesystem::path fileToRead(const std::string& name) const;

  /// Returns the path of a file to be written, which may be missing. Throws InputError as fileToRead() does, and for
  /// any symbolic link.
  [[nodiscard]] std::filesystem::path fileToWrite(const std::string& name) const;

  /// Returns the names of the plain files with that extension (".yaml"), sorted; at most a thousand.
  [[nodiscard]] std::vector<std::string> names(const std::string& extension) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tubeplan::app
