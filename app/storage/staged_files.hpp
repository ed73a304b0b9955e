// Files that are written next to their final paths, flushed to the disk and renamed together; and folders created for
// such files, which are removed again if they remain empty.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace tubeplan::app {

/// Throws InputError for an output that cannot be written, with a message such as "--out: '/there/file' cannot be
/// written (WHY)".
[[noreturn]] void failToWrite(const std::string& option, const std::filesystem::path& path, const std::string& why);

/// Creates or truncates a file, writes `content` and flushes it to the disk; a device or pipe is not flushed.
[[nodiscard]] std::error_code writeToDisk(const std::filesystem::path& path, const std::string& content);

/// Flushes a folder's directory entries to the disk.
[[nodiscard]] std::error_code syncFolder(const std::filesystem::path& folder);

/// Set of temporary files to be renamed together. The destructor removes files not yet renamed, so that a failure
/// leaves the old files unchanged.
class StagedFiles {
 public:
  explicit StagedFiles(std::string option) : option_(std::move(option)) {}
  ~StagedFiles() { discard(); }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Writes `content` to the file `temporary`. At putInPlace() the old file at `place` is kept as `backup`, and
  /// `temporary` is renamed to `place`. Throws InputError.
  void add(std::filesystem::path temporary, std::filesystem::path backup, std::filesystem::path place,
           const std::string& content);

  /// Renames the files in the order in which they were added, and flushes each rename to the disk before the next. On
  /// failure, throws InputError and restores the old files, unless only the flush of the last rename failed.
  void putInPlace();

  /// Removes temporary files that have not been renamed to their final paths.
  void discard() noexcept;

 private:
  struct File {
    std::filesystem::path temporary, backup, place;
    bool is_placed = false, has_old = false;
  };

  [[nodiscard]] static std::error_code place(File& file, bool is_last);
  void rollBack();

  std::string option_;
  std::vector<File> files_;
};

class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();  ///< removes the folders that are still empty
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  /// Creates all missing folders on the path to `folder`, and `folder` itself. Throws InputError naming the option.
  void make(const std::filesystem::path& folder, const std::string& option);

  /// Flushes the directory entries of the created folders to the disk. Throws InputError naming the option.
  void sync(const std::string& option) const;

 private:
  std::vector<std::filesystem::path> paths_;  ///< created folders, outermost first
};

/// Exclusive lock on a folder or file among processes, held until release() or the end of the process. No lock file is
/// left behind.
class FileLock {
 public:
  enum class Outcome { kTaken, kHeldByAnother, kNotPossible };

  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Tries to take the lock without waiting; `flags` are passed to open(). Returns kNotPossible if the path cannot be
  /// opened or its file system has no locks.
  [[nodiscard]] Outcome tryTake(const std::filesystem::path& place, int flags);
  void release();

 private:
  int descriptor_ = -1;
};

}  // namespace tubeplan::app
