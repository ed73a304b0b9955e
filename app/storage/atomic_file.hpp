// Files written completely or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/storage/staged_files.hpp"

namespace tubeplan::app {

/// File to be written.
struct TextFile {
  std::filesystem::path path;
  std::string text;
};

/// Throws InputError, naming the option, unless a file can be written there. Its folder must exist or be possible to
/// create; the path must be no folder, no file that the command reads and no output of another option (InputRecord).
/// Leaves no files behind, and removes leftovers of programs that were killed. For use before long work.
void checkWritableFile(const std::filesystem::path& path, const std::string& option);

/// Writes beside the path, waits for the disk and renames, so that no reader sees a part of a file, not even after a
/// power failure. Writes directly to a device or pipe and never replaces it. Creates missing folders. Throws InputError
/// naming the option.
void writeFileAtomically(const std::filesystem::path& path, const std::string& content, const std::string& option);

/// Writes files that belong together: all of them, or none if one cannot be written. Renames them in this order, each
/// on the disk before the next. Throws InputError naming the option.
void writeFilesTogether(const std::vector<TextFile>& files, const std::string& option);

/// Removes the temporary files beside `name` of programs that were killed while they wrote it.
void removeLeftovers(const std::filesystem::path& folder, const std::string& name);

/// Folder of results. It is created and checked for write access at once; its files appear together at commit().
/// Without a commit nothing remains, not even folders that had to be created.
class OutputFolder {
 public:
  /// Throws InputError, naming the option, for a folder that cannot be created or written, or to which another program
  /// is writing: the files of two runs would be mixed.
  OutputFolder(const std::filesystem::path& path, const std::string& option);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Throws InputError, naming the option, if files of these names exist but none of the `marks` that runs of the same
  /// command leave beside them: they belong to something else.
  void requireOwn(const std::vector<std::string>& marks, const std::vector<std::string>& names) const;

  /// Writes a file of the folder; `name` has no folders.
  void write(const std::string& name, const std::string& content);

  /// Marks a file of an earlier run, which does not belong to the new files, for removal at commit().
  void remove(const std::string& name);

  /// Renames all files to their final names, replacing older ones of the same names, or none; other files of the folder
  /// stay.
  void commit();

 private:
  MadeFolders made_;
  FileLock lock_;
  std::filesystem::path path_, scratch_;
  std::string option_;
  StagedFiles staged_;
  std::vector<std::filesystem::path> stale_;
};

}  // namespace tubeplan::app
