// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/storage/staged_files.hpp"

namespace tubeplan::app {

/// A file to be written.
struct TextFile {
  std::filesystem::path path;
  std::string text;
};

/// Throws InputError, naming the option, unless a file can be written there: the folder exists or can be made, the
/// place is no folder, and it is no file that the command reads or another option writes (InputRecord). Leaves nothing
/// behind, not even what a program that was killed left. For use before long work.
void checkWritableFile(const std::filesystem::path& path, const std::string& option);

/// Writes beside the place, waits for the disk and renames, so that no reader ever sees half a file, nor one after a
/// power cut; a device or pipe is written to as it is, never replaced. Makes missing folders. Throws InputError naming
/// the option.
void writeFileAtomically(const std::filesystem::path& path, const std::string& content, const std::string& option);

/// The same for files that belong together: where one cannot be written, none is. They go to their places in this
/// order, each on the disk before the next.
void writeFilesTogether(const std::vector<TextFile>& files, const std::string& option);

/// Removes what programs that were killed while they wrote `name` left beside it.
void removeLeftovers(const std::filesystem::path& folder, const std::string& name);

/// A folder of results: made and proved writable at once, its files appear together at commit(). Without a commit
/// nothing remains, not even folders that had to be made.
class OutputFolder {
 public:
  /// Throws InputError, naming the option, for a folder that cannot be made or written, or that another program writes
  /// to: files of two runs would be mixed.
  OutputFolder(const std::filesystem::path& path, const std::string& option);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Throws InputError, naming the option, where there are files of these names and none of the `marks` that runs of
  /// the same command leave beside them: they are someone else's.
  void requireOwn(const std::vector<std::string>& marks, const std::vector<std::string>& names) const;

  /// Of a file name without folders.
  void write(const std::string& name, const std::string& content);

  /// A file of an earlier run that would not belong to these: gone after commit().
  void remove(const std::string& name);

  /// Puts all files in place, over older ones of the same names, or none; others in the folder stay.
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
