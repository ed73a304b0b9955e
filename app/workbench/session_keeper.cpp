#include "app/workbench/session_keeper.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/formats/checkpoint/plan_key.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/project.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr int kMostAtOnce = 16;  // maximum number of programs that work on the same cell at a time
constexpr std::size_t kMostRecent = 20;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Returns a session name such as "bench-1a2b3c4d5e6f7081", from the name of the cell file and a hash of its path.
std::string sessionName(const std::string& cell) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(cell, error);
  return fs::path(cell).stem().string() + "-" + fingerprintOf(error ? cell : place.string());
}

/// Returns an unused file name in the folder of `file`.
fs::path freeName(const fs::path& file, const std::string& word) {
  for (int k = 1;; ++k) {
    const auto other =
        fs::path(file).replace_filename(fmt::format("{}-{}-{}{}", file.stem().string(), word, k, kProjectExtension));
    std::error_code error;
    if (!fs::exists(other, error)) return other;
  }
}

}  // namespace

std::string defaultStateFolder() {
  const std::string state = variable("XDG_STATE_HOME"), home = variable("HOME");
  if (!state.empty()) return state + "/tubeplan";
  return home.empty() ? "" : home + "/.local/state/tubeplan";
}

SessionKeeper::SessionKeeper(fs::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  checkWritableFile(folder_ / "session", "--state");
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path made = fs::canonical(folder_, error);
  if (error)
    throw InputError::problem("--state",
                              fmt::format("the folder '{}' cannot be created: {}", folder_.string(), error.message()),
                              "choose a folder with write permission");
  folder_ = made;
}

std::optional<Session> SessionKeeper::begin(const std::string& cell) {
  if (folder_.empty()) return std::nullopt;
  const std::lock_guard guard(mutex_);
  lock_.release();
  file_.clear();
  kept_ = 0;
  const std::string name = sessionName(cell);
  for (int k = 1; k <= kMostAtOnce && file_.empty(); ++k) {
    const auto file =
        folder_ / (k == 1 ? name + kProjectExtension : fmt::format("{}-{}{}", name, k, kProjectExtension));
    if (lock_.tryTake(fs::path(file).concat(".lock"), O_CREAT | O_RDWR) == FileLock::Outcome::kTaken) file_ = file;
  }
  std::error_code error;
  if (file_.empty() || !fs::exists(file_, error)) return std::nullopt;
  removeLeftovers(folder_, file_.filename().string());
  try {
    return readProject(file_);
  } catch (const InputError& problem) {
    const auto other = freeName(file_, "unreadable");
    fs::rename(file_, other, error);
    fmt::print(stderr, "tubeplan: the saved session is not resumed, and remains as {}: {}\n", other.string(),
               problem.what());
    return std::nullopt;
  }
}

void SessionKeeper::putAside() {
  const std::lock_guard guard(mutex_);
  std::error_code error;
  if (!file_.empty() && fs::exists(file_, error)) fs::rename(file_, freeName(file_, "earlier"), error);
}

void SessionKeeper::keep(const Session& session) {
  const std::lock_guard guard(mutex_);
  if (file_.empty() || session.revision <= kept_) return;
  try {
    writeFileAtomically(file_, projectText(session), "--state");
    kept_ = session.revision;
    problem_.clear();
  } catch (const std::exception& error) {
    if (problem_.empty()) fmt::print(stderr, "tubeplan: the session is not saved: {}\n", error.what());
    problem_ = error.what();
  }
}

std::string SessionKeeper::problem() const {
  const std::lock_guard guard(mutex_);
  return problem_;
}

fs::path SessionKeeper::file() const {
  const std::lock_guard guard(mutex_);
  return file_;
}

nlohmann::json SessionKeeper::recent() const {
  nlohmann::json list = nlohmann::json::array();
  if (folder_.empty()) return list;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  const fs::path own = file();
  for (const auto& entry : fs::directory_iterator(folder_, error))
    if (entry.path().extension() == kProjectExtension && entry.is_regular_file(error) && entry.path() != own)
      files.emplace_back(entry.last_write_time(error), entry.path());
  std::sort(files.rbegin(), files.rend());
  for (const auto& [time, path] : files) {
    const auto summary = projectSummary(path);
    if (!summary.is_null()) list.push_back(summary);
    if (list.size() == kMostRecent) break;
  }
  return list;
}

}  // namespace tubeplan::app
