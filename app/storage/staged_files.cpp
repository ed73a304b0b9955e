#include "app/storage/staged_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

std::error_code lastError() { return {errno, std::generic_category()}; }

/// File descriptor, which the destructor closes if close() was not called.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() { (void)close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] bool isOpen() const { return number_ >= 0; }

  [[nodiscard]] bool writeAll(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = ::write(number_, content.data(), content.size());
      if (written < 0 && errno != EINTR) return false;
      if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  /// Flushes the file to the disk. Also returns true for files that cannot be flushed (pipes, some file systems).
  [[nodiscard]] bool sync() const {
    while (::fsync(number_) != 0) {
      if (errno == EINVAL || errno == ENOTSUP || errno == ENOSYS || errno == EROFS) return true;
      if (errno != EINTR) return false;
    }
    return true;
  }

  /// Closes the descriptor. Returns false if closing fails, because some file systems report a failed write only then.
  [[nodiscard]] bool close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0 || errno == EINTR;
  }

 private:
  int number_;
};

fs::path parentOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Keeps the old file under a second name, by a hard link, so that `place` exists at all times. On file systems without
/// hard links the old file is renamed instead.
std::error_code keepBackup(const fs::path& place, const fs::path& backup) {
  std::error_code error;
  if (fs::is_directory(place, error)) return std::make_error_code(std::errc::is_a_directory);
  fs::remove(backup, error);
  fs::create_hard_link(place, backup, error);
  if (error) fs::rename(place, backup, error);
  return error;
}

}  // namespace

void failToWrite(const std::string& option, const fs::path& path, const std::string& why) {
  throw InputError::problem(option, fmt::format("'{}' cannot be written ({})", path.string(), why),
                            "choose another place, or check its permissions and the free space");
}

std::error_code writeToDisk(const fs::path& path, const std::string& content) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  const bool is_done = file.isOpen() && file.writeAll(content) && file.sync() && file.close();
  return is_done ? std::error_code() : lastError();
}

std::error_code syncFolder(const fs::path& folder) {
  const Descriptor list(folder, O_RDONLY | O_DIRECTORY);
  // A folder without read permission cannot be opened for flushing, which is not an error.
  return !list.isOpen() || list.sync() ? std::error_code() : lastError();
}

void StagedFiles::discard() noexcept {
  std::error_code ignored;
  for (const File& file : files_) {
    if (!file.is_placed) fs::remove(file.temporary, ignored);
    fs::remove(file.backup, ignored);
  }
  files_.clear();
}

void StagedFiles::add(fs::path temporary, fs::path backup, fs::path place, const std::string& content) {
  files_.push_back({std::move(temporary), std::move(backup), std::move(place)});
  const File& file = files_.back();
  if (const auto error = writeToDisk(file.temporary, content))
    failToWrite(option_, parentOf(file.place), error.message());
}

void StagedFiles::putInPlace() {
  for (File& file : files_) {
    const bool is_last = &file == &files_.back();
    const std::error_code error = place(file, is_last);
    if (!error) continue;
    if (!is_last || !file.is_placed) rollBack();
    failToWrite(option_, file.place, error.message());
  }
  discard();
}

std::error_code StagedFiles::place(File& file, bool is_last) {
  std::error_code error;
  if (!is_last && fs::exists(file.place, error)) {
    if ((error = keepBackup(file.place, file.backup))) return error;
    file.has_old = true;
  }
  fs::rename(file.temporary, file.place, error);
  if (error) return error;
  file.is_placed = true;
  return syncFolder(parentOf(file.place));
}

void StagedFiles::rollBack() {
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) {
    std::error_code failure;
    if (file->has_old)
      fs::rename(file->backup, file->place, failure);
    else if (file->is_placed)
      fs::remove(file->place, failure);
    // Leaves the old file at `backup`, so that the user can recover it.
    if (file->has_old && failure) file->backup.clear();
  }
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;
  for (auto folder = paths_.rbegin(); folder != paths_.rend(); ++folder) fs::remove(*folder, ignored);
}

void MadeFolders::make(const fs::path& folder, const std::string& option) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    missing.insert(missing.begin(), at);
    if (at == at.parent_path()) break;
  }
  paths_.insert(paths_.end(), missing.begin(), missing.end());
  fs::create_directories(folder, error);
  if (error) failToWrite(option, folder, error.message());
  if (!fs::is_directory(folder, error)) failToWrite(option, folder, "not a folder");
}

void MadeFolders::sync(const std::string& option) const {
  for (const fs::path& folder : paths_)
    if (const auto error = syncFolder(parentOf(folder))) failToWrite(option, folder, error.message());
}

FileLock::Outcome FileLock::tryTake(const fs::path& place, int flags) {
  release();
  descriptor_ = ::open(place.c_str(), flags | O_CLOEXEC, 0600);
  if (descriptor_ < 0) return Outcome::kNotPossible;
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return Outcome::kTaken;
  const bool is_held = errno == EWOULDBLOCK;
  release();
  return is_held ? Outcome::kHeldByAnother : Outcome::kNotPossible;
}

void FileLock::release() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

}  // namespace tubeplan::app
