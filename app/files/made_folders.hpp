// Folders that files are written to: those that are made are gone again where none comes, and one program at a time
// holds one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tubeplan::app {

class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();  ///< those still empty go
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  /// All that are missing on the way to `folder`. Throws InputError naming the option.
  void make(const std::filesystem::path& folder, const std::string& option);

  /// Waits until they are on the disk themselves, not only what is in them. Throws InputError.
  void sync(const std::string& option) const;

 private:
  std::vector<std::filesystem::path> paths_;  ///< outermost first
};

/// Held until it goes, or its program ends, however it does: nothing is left that could be stale.
class FolderLock {
 public:
  FolderLock() = default;
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False where another program, or another lock of this one, holds the folder. A file system without locks has none
  /// to refuse.
  [[nodiscard]] bool tryTake(const std::filesystem::path& folder);

 private:
  int descriptor_ = -1;
};

}  // namespace tubeplan::app
