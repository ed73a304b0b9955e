// The one folder whose files the workbench may read and write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tubeplan::app {

class OpenedFolder {
 public:
  /// Throws InputError for what is no folder.
  explicit OpenedFolder(const std::filesystem::path& folder);

  /// The canonical place of an existing file by its plain name. Throws InputError for a name with folders in it, a
  /// hidden one, and one that leads out of the folder (a symbolic link).
  [[nodiscard]] std::filesystem::path fileToRead(const std::string& name) const;

  /// The same for a file to be written, which may be missing; never over a symbolic link.
  [[nodiscard]] std::filesystem::path fileToWrite(const std::string& name) const;

  /// Names of the plain files with that extension (".yaml"), sorted; at most a thousand.
  [[nodiscard]] std::vector<std::string> names(const std::string& extension) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tubeplan::app
