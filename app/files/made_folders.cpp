#include "app/files/made_folders.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/files/staged_files.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

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
    if (const auto error = syncFolder(folder.has_parent_path() ? folder.parent_path() : "."))
      failToWrite(option, folder, error.message());
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool FolderLock::tryTake(const fs::path& folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace tubeplan::app
