// Files that are written beside their places, brought to the disk, and go to their places together; folders that are
// made for them, and gone again where none comes.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace tubeplan::app {

/// "--out: found '/there/file': WHY": the InputError for what cannot be written.
[[noreturn]] void failToWrite(const std::string& option, const std::filesystem::path& path, const std::string& why);

/// Makes or empties a file and waits until all of `content` is on the disk. A device or pipe just gets it.
[[nodiscard]] std::error_code writeToDisk(const std::filesystem::path& path, const std::string& content);

/// Waits until a folder's list of files is on the disk.
[[nodiscard]] std::error_code syncFolder(const std::filesystem::path& folder);

/// What has not been put in place is gone in the end, so that a failure leaves the old files alone.
class StagedFiles {
 public:
  explicit StagedFiles(std::string option) : option_(std::move(option)) {}
  ~StagedFiles() { discard(); }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Writes to `temporary`; while the set goes to its places the old file waits at `aside`. Throws InputError.
  void add(std::filesystem::path temporary, std::filesystem::path aside, std::filesystem::path place,
           const std::string& content);

  /// In the order in which they were added, each on the disk before the next. Throws InputError; the old files are
  /// then back in their places, unless nothing but the disk's word for the last one is missing.
  void putInPlace();

  /// Removes what has not been put in place.
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

/// One program at a time holds a folder or file, until it releases it or ends, however it does: nothing is left that
/// could be stale.
class FileLock {
 public:
  enum class Outcome { kTaken, kHeldByAnother, kNotPossible };

  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// `flags` are those of open(). What cannot be opened, or has no locks in its file system, is nobody's.
  [[nodiscard]] Outcome tryTake(const std::filesystem::path& place, int flags);
  void release();

 private:
  int descriptor_ = -1;
};

}  // namespace tubeplan::app
