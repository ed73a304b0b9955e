#include "app/storage/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <system_error>

#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

fs::path temporaryPath(const fs::path& path) {
  return folderOf(path) / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
}

std::string asideName(const fs::path& path) { return path.filename().string() + ".old"; }

/// Returns the process id in a temporary file's name ".NAME.1234.part"; 0 if `file` is not such a name.
int writerOf(const std::string& file, const std::string& name) {
  const std::string before = "." + name + ".", after = ".part";
  if (!file.starts_with(before) || !file.ends_with(after) || file.size() <= before.size() + after.size()) return 0;
  int number = 0;
  const char* end = file.data() + file.size() - after.size();
  const auto [read_to, error] = std::from_chars(file.data() + before.size(), end, number);
  return error == std::errc() && read_to == end && number > 0 ? number : 0;
}

bool isRunning(int process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

// Returns true for a device or pipe (/dev/null, /dev/stdout). Such a path is written directly, because a rename would
// replace it with a regular file.
bool isSpecialFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Returns the target if `named` is a symbolic link, so that the target is replaced and the link kept; otherwise
// `named`.
fs::path behindLink(const fs::path& named) {
  std::error_code error;
  return fs::is_symlink(named, error) ? fs::weakly_canonical(named, error) : named;
}

constexpr const char* kScratch = "tubeplan";  // name of the scratch folder within an OutputFolder

/// Returns a string such as " (process 1234)" that names the running process with a scratch folder in `folder`; empty
/// if there is none.
std::string holderOf(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const int writer = writerOf(entry.path().filename().string(), kScratch); writer > 0 && isRunning(writer))
      return fmt::format(" (process {})", writer);
  return "";
}

void refuseFolder(const fs::path& path, const std::string& option) {
  std::error_code error;
  if (path.filename().empty() || fs::is_directory(path, error))
    throw InputError(option, fmt::format("the folder '{}'", path.string()), "the name of a file", "add a file name");
  if (path == "-") throw InputError(option, "'-'", "the name of a file", "only --json accepts - for standard output");
}

fs::path absoluteFolder(const fs::path& path, const std::string& option) {
  if (path.empty()) throw InputError(option, "''", "the name of a folder", "give a folder, which may be new");
  return fs::absolute(path).lexically_normal();
}

}  // namespace

void checkWritableFile(const fs::path& named, const std::string& option) {
  refuseFolder(named, option);
  const fs::path path = behindLink(named);
  if (isSpecialFile(path)) return;
  claimOutput(path, option);
  MadeFolders made;
  made.make(folderOf(path), option);
  removeLeftovers(folderOf(path), path.filename().string());
  removeLeftovers(folderOf(path), asideName(path));
  StagedFiles(option).add(temporaryPath(path), {}, path, "");
}

void writeFileAtomically(const fs::path& path, const std::string& content, const std::string& option) {
  writeFilesTogether({{path, content}}, option);
}

void writeFilesTogether(const std::vector<TextFile>& files, const std::string& option) {
  MadeFolders made;
  StagedFiles staged(option);
  for (const TextFile& file : files) {
    refuseFolder(file.path, option);
    const fs::path path = behindLink(file.path);
    if (isSpecialFile(path)) {
      if (const auto error = writeToDisk(path, file.text)) failToWrite(option, path, error.message());
      continue;
    }
    claimOutput(path, option);
    made.make(folderOf(path), option);
    staged.add(temporaryPath(path), temporaryPath(folderOf(path) / asideName(path)), path, file.text);
  }
  made.sync(option);
  staged.putInPlace();
}

void removeLeftovers(const fs::path& folder, const std::string& name) {
  std::error_code error;
  std::vector<fs::path> leftovers;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const int writer = writerOf(entry.path().filename().string(), name); writer > 0 && !isRunning(writer))
      leftovers.push_back(entry.path());
  for (const fs::path& path : leftovers) fs::remove_all(path, error);
}

OutputFolder::OutputFolder(const fs::path& path, const std::string& option)
    : path_(absoluteFolder(path, option)), option_(option), staged_(option) {
  if (!path_.has_filename()) path_ = path_.parent_path();  // removes a trailing slash
  std::error_code error;
  if (fs::exists(path_, error) && !fs::is_directory(path_))
    throw InputError::problem(option, fmt::format("'{}' is a file, not a folder", path_.string()),
                              "give a folder, which may be new");
  made_.make(path_, option);
  if (lock_.tryTake(path_, O_RDONLY | O_DIRECTORY) == FileLock::Outcome::kHeldByAnother)
    throw InputError::problem(
        option, fmt::format("another run of tubeplan{} is writing to '{}'", holderOf(path_), path_.string()),
        "wait until it has finished, or choose another folder");
  removeLeftovers(path_, kScratch);
  scratch_ = path_ / fmt::format(".{}.{}.part", kScratch, ::getpid());
  fs::create_directory(scratch_, error);
  if (error) failToWrite(option, path_, error.message());
}

// Allocates no memory, so that the clean-up also works after std::bad_alloc.
OutputFolder::~OutputFolder() {
  staged_.discard();
  std::error_code ignored;
  fs::remove(scratch_, ignored);
}

void OutputFolder::requireOwn(const std::vector<std::string>& marks, const std::vector<std::string>& names) const {
  const auto isThere = [this](const std::string& name) {
    std::error_code error;
    return fs::exists(path_ / name, error);
  };
  if (std::ranges::any_of(marks, isThere)) return;
  if (const auto other = std::ranges::find_if(names, isThere); other != names.end())
    throw InputError::problem(
        option_,
        (path_ / *other).string() + " was not written by an earlier run of this command and would be overwritten",
        "choose an empty folder, or the folder of an earlier run");
}

void OutputFolder::write(const std::string& name, const std::string& content) {
  assert(name.find('/') == std::string::npos);
  staged_.add(scratch_ / name, scratch_ / (name + ".old"), path_ / name, content);
}

void OutputFolder::remove(const std::string& name) { stale_.push_back(path_ / name); }

void OutputFolder::commit() {
  made_.sync(option_);
  staged_.putInPlace();
  std::error_code ignored;  // failure to remove an old file is harmless
  for (const fs::path& path : stale_) fs::remove(path, ignored);
}

}  // namespace tubeplan::app
