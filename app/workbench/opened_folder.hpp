// The only folder whose files the workbench may read and write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tubeplan::app {

class OpenedFolder {
 public:
  /// Opens a folder. Throws InputError if it is not a folder.
  explicit OpenedFolder(const std::filesystem::path& folder);

  /// Returns the canonical path of an existing file, given its plain name. Throws InputError for a name that contains a
  /// folder, for a hidden file, and for a symbolic link that leads out of the folder.
  [[nodiscard]] std::filesystem::path fileToRead(const std::string& name) const;

  /// Returns the path of a file to write, which may not exist yet. Throws InputError like fileToRead(), and for any
  /// symbolic link.
  [[nodiscard]] std::filesystem::path fileToWrite(const std::string& name) const;

  /// Returns the sorted names of the regular files with this extension (".yaml"), at most a thousand.
  [[nodiscard]] std::vector<std::string> names(const std::string& extension) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tubeplan::app
