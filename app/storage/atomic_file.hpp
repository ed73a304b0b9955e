// Files that are written completely or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/storage/staged_files.hpp"

namespace tubeplan::app {

/// A file to be written: path and content.
struct TextFile {
  std::filesystem::path path;
  std::string text;
};

/// Throws InputError, naming the option, unless a file can be written at the path. Its folder must exist, or it must be
/// possible to create it. The path must not be a folder, a file that the command reads or the output of another option
/// (InputRecord). Leaves no files behind, and removes temporary files of killed programs. Call it before
/// long work.
void checkWritableFile(const std::filesystem::path& path, const std::string& option);

/// Writes a temporary file next to the path, flushes it to the disk and renames it. No reader sees a partial file, not
/// even after a power failure. A device or pipe is written directly and never replaced. Creates missing folders. Throws
/// InputError naming the option.
void writeFileAtomically(const std::filesystem::path& path, const std::string& content, const std::string& option);

/// Writes files that belong together: all of them, or none if one of them cannot be written. Renames them in the given
/// order, and flushes each rename to the disk before the next. Throws InputError naming the option.
void writeFilesTogether(const std::vector<TextFile>& files, const std::string& option);

/// Removes temporary files for `name` that killed programs left in the folder.
void removeLeftovers(const std::filesystem::path& folder, const std::string& name);

/// Folder for results. The constructor creates the folder and checks write access. All files appear together at
/// commit(); without commit(), nothing remains, not even created folders.
class OutputFolder {
 public:
  /// Throws InputError, naming the option, if the folder cannot be created or written, or if another program is writing
  /// to it, which would mix the files of two runs.
  OutputFolder(const std::filesystem::path& path, const std::string& option);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Throws InputError, naming the option, if the folder contains a file of `names` but no file of `marks`. Every run
  /// of the same command writes the marks, so without them the files are not from an earlier run.
  void requireOwn(const std::vector<std::string>& marks, const std::vector<std::string>& names) const;

  /// Writes a file to be placed in the folder at commit(); `name` is a file name without folders.
  void write(const std::string& name, const std::string& content);

  /// Marks a file of an earlier run for removal at commit(), because the file does not belong to the new results.
  void remove(const std::string& name);

  /// Renames all files to their final names, or none if a rename fails. Replaces older files of the same names; other
  /// files of the folder are kept.
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
