#include "app/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include "app/files/input_error.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& option, const fs::path& path, const std::string& why) {
  throw InputError(option, fmt::format("'{}': {}", path.string(), why), "a place that can be written",
                   "choose another");
}

// The folders on the way to `folder` that do not exist yet, outermost first.
std::vector<fs::path> missingFolders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    missing.insert(missing.begin(), at);
    if (at == at.parent_path()) break;
  }
  return missing;
}

std::vector<fs::path> makeFolders(const fs::path& folder, const std::string& option) {
  const std::vector<fs::path> missing = missingFolders(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    for (auto made = missing.rbegin(); made != missing.rend(); ++made) {
      std::error_code ignored;
      fs::remove(*made, ignored);
    }
    fail(option, folder, error ? error.message() : "not a folder");
  }
  return missing;
}

// Only those still empty go.
void removeFolders(const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) fs::remove(*folder, ignored);
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

fs::path temporaryBeside(const fs::path& path) {
  return folderOf(path) / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
}

/// The number in ".NAME.1234.part"; 0 in any other name.
int writerOf(const std::string& file, const std::string& name) {
  const std::string before = "." + name + ".", after = ".part";
  if (!file.starts_with(before) || !file.ends_with(after) || file.size() <= before.size() + after.size()) return 0;
  int number = 0;
  const char* end = file.data() + file.size() - after.size();
  const auto [read_to, error] = std::from_chars(file.data() + before.size(), end, number);
  return error == std::errc() && read_to == end && number > 0 ? number : 0;
}

bool isRunning(int process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

// A device or pipe (/dev/null, /dev/stdout) is written to; a rename would put a file in its place.
bool isSpecialFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void writeContent(const fs::path& path, const std::string& content, const std::string& option) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (stream.fail()) {
    const std::string why = errno ? std::strerror(errno) : "cannot be written";
    if (isSpecialFile(path)) fail(option, path, why);
    std::error_code ignored;
    fs::remove(path, ignored);
    fail(option, path.parent_path(), why);
  }
}

/// Waits until a file's content, or a folder's list of files, is on the disk: what was renamed over an older file
/// before its content was there would be neither after a power cut. A file system that cannot is not waited for.
void sync(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  (void)::fsync(file);
  ::close(file);
}

void refuseFolder(const fs::path& path, const std::string& option) {
  std::error_code error;
  if (path.filename().empty() || fs::is_directory(path, error))
    throw InputError(option, fmt::format("'{}', a folder", path.string()), "the name of a file", "add a file name");
}

}  // namespace

void checkWritableFile(const fs::path& path, const std::string& option) {
  refuseFolder(path, option);
  if (isSpecialFile(path)) return;
  const auto made = makeFolders(folderOf(path), option);
  const fs::path probe = temporaryBeside(path);
  try {
    writeContent(probe, "", option);
  } catch (const InputError&) {
    removeFolders(made);
    throw;
  }
  std::error_code ignored;
  fs::remove(probe, ignored);
  removeFolders(made);
}

void writeFileAtomically(const fs::path& named, const std::string& content, const std::string& option) {
  refuseFolder(named, option);
  std::error_code error;
  // The file behind a link is replaced, not the link.
  const fs::path path = fs::is_symlink(named, error) ? fs::weakly_canonical(named, error) : named;
  if (isSpecialFile(path)) return writeContent(path, content, option);
  makeFolders(folderOf(path), option);
  const fs::path temporary = temporaryBeside(path);
  writeContent(temporary, content, option);
  sync(temporary);
  fs::rename(temporary, path, error);
  if (!error) return sync(folderOf(path));
  std::error_code ignored;
  fs::remove(temporary, ignored);
  fail(option, path, error.message());
}

void removeLeftovers(const fs::path& folder, const std::string& name) {
  std::error_code error;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const int writer = writerOf(entry.path().filename().string(), name); writer > 0 && !isRunning(writer))
      left.push_back(entry.path());
  for (const fs::path& path : left) fs::remove_all(path, error);
}

OutputFolder::OutputFolder(const fs::path& path, const std::string& option)
    : path_(fs::absolute(path).lexically_normal()), option_(option) {
  if (!path_.has_filename()) path_ = path_.parent_path();  // a name that ends with a slash
  std::error_code error;
  if (fs::exists(path_, error) && !fs::is_directory(path_)) fail(option, path_, "a file, not a folder");
  made_ = makeFolders(path_, option);
  removeLeftovers(path_, "tubeplan");
  scratch_ = path_ / fmt::format(".tubeplan.{}.part", ::getpid());
  fs::create_directory(scratch_, error);
  if (!error) return;
  removeFolders(made_);
  fail(option, path_, error.message());
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);
  removeFolders(made_);
}

void OutputFolder::write(const std::string& name, const std::string& content) {
  assert(name.find('/') == std::string::npos);
  writeContent(scratch_ / name, content, option_);
  names_.push_back(name);
}

void OutputFolder::remove(const std::string& name) { stale_.push_back(name); }

void OutputFolder::commit() {
  for (const std::string& name : names_) sync(scratch_ / name);
  for (const std::string& name : names_) {
    std::error_code error;
    fs::rename(scratch_ / name, path_ / name, error);
    if (error) fail(option_, path_ / name, error.message());
  }
  names_.clear();
  sync(path_);
  std::error_code ignored;  // a stale file that stays does no harm beyond itself
  for (const std::string& name : stale_) fs::remove(path_ / name, ignored);
}

}  // namespace tubeplan::app
