// Files that are written beside their final paths, flushed to the disk and renamed together; folders created for them,
// and removed again if they stay empty.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace tubeplan::app {

/// Throws the InputError for an output that cannot be written: "--out: '/there/file' cannot be written (WHY)".
[[noreturn]] void failToWrite(const std::string& option, const std::filesystem::path& path, const std::string& why);

/// Creates or empties a file and waits until all of `content` is on the disk. Writes to a device or pipe without
/// waiting.
[[nodiscard]] std::error_code writeToDisk(const std::filesystem::path& path, const std::string& content);

/// Waits until a folder's list of files is on the disk.
[[nodiscard]] std::error_code syncFolder(const std::filesystem::path& folder);

/// Set of temporary files. The destructor removes those that were not renamed, so that a failure leaves the old files
/// unchanged.
class StagedFiles {
 public:
  explicit StagedFiles(std::string option) : option_(std::move(option)) {}
  ~StagedFiles() { discard(); }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Writes `content` to `temporary`; putInPlace() later moves the old file from `place` to `aside` and this one to
  /// `place`. Throws InputError.
  void add(std::filesystem::path temporary, std::filesystem::path aside, std::filesystem::path place,
           const std::string& content);

  /// Renames the files in the order of their addition, each on the disk before the next. Throws InputError and restores
  /// the old files, unless the only failure is to flush the last rename to the disk.
  void putInPlace();

  /// Removes the files that have not been renamed to their final paths.
  void discard() noexcept;

 private:
  struct File {
    std::filesystem::path temporary, aside, place;
    bool is_placed = false, has_old = false;
  };

  [[nodiscard]] static std::error_code place(File& file, bool is_last);
  void takeBack();

  std::string option_;
  std::vector<File> files_;
};

class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();  ///< removes the folders that are still empty
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  /// Creates all missing folders on the path to `folder`. Throws InputError naming the option.
  void make(const std::filesystem::path& folder, const std::string& option);

  /// Waits until the folders themselves are on the disk, not only their content. Throws InputError.
  void sync(const std::string& option) const;

 private:
  std::vector<std::filesystem::path> paths_;  ///< created folders, outermost first
};

/// Lock on a folder or file for one program at a time, until its release or the end of the process. No lock file
/// remains.
class FileLock {
 public:
  enum class Outcome { kTaken, kHeldByAnother, kNotPossible };

  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Tries to take the lock; `flags` are those of open(). Returns kNotPossible for a path that cannot be opened or a
  /// file system without locks.
  [[nodiscard]] Outcome tryTake(const std::filesystem::path& place, int flags);
  void release();

 private:
  int descriptor_ = -1;
};

}  // namespace tubeplan::app
