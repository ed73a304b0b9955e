// Files that are written beside their places, brought to the disk, and go to their places together.
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

}  // namespace tubeplan::app
