#include "app/workbench/opened_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 200;
constexpr std::size_t kMostNames = 1000;

void requirePlainName(const std::string& name) {
  const bool is_plain = !name.empty() && name.size() <= kLongestName && name.front() != '.' &&
                        std::all_of(name.begin(), name.end(), [](char c) {
                          return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '/' && c != '\\';
                        });
  if (!is_plain) throw InputError("file", inQuotes(name), "the plain name of a file in the opened folder");
}

}  // namespace

OpenedFolder::OpenedFolder(const fs::path& folder) {
  std::error_code error;
  path_ = fs::canonical(folder, error);
  const std::string quoted = inQuotes(folder.string());
  if (error)
    throw InputError::problem("--folder", fmt::format("{} cannot be opened: {}", quoted, error.message()),
                              "check the name");
  if (!fs::is_directory(path_, error))
    throw InputError::problem("--folder", quoted + " is not a folder", "give the folder with the files");
}

fs::path OpenedFolder::fileToRead(const std::string& name) const {
  requirePlainName(name);
  std::error_code error;
  const fs::path place = fs::canonical(path_ / name, error);
  if (error)
    throw InputError::problem(name, "there is no such file in the opened folder",
                              "choose another (GET /api/files lists them)");
  if (place.parent_path() != path_)
    throw InputError::problem(name, "this symbolic link points outside the opened folder",
                              "copy the file into the folder");
  if (!fs::is_regular_file(place, error))
    throw InputError::problem(name, "this is not a regular file", "choose a file of the opened folder");
  return place;
}

fs::path OpenedFolder::fileToWrite(const std::string& name) const {
  requirePlainName(name);
  const fs::path place = path_ / name;
  std::error_code error;
  const auto status = fs::symlink_status(place, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError::problem(name, "this is not a regular file but, for example, a folder", "choose another name");
  return place;
}

std::vector<std::string> OpenedFolder::names(const std::string& extension) const {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path_, error)) {
    const std::string name = entry.path().filename().string();
    if (name.front() == '.' || entry.path().extension() != extension || !entry.is_regular_file(error)) continue;
    names.push_back(name);
    if (names.size() == kMostNames) break;
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace tubeplan::app
