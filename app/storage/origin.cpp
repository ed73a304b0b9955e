#include "app/storage/origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <system_error>

#include "app/storage/input_error.hpp"
#include "app/storage/sha256.hpp"
#include "app/storage/utf8.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

thread_local InputRecord* record_of_thread = nullptr;

/// Returns the file name of a path as UTF-8, with a question mark for each byte that is not UTF-8.
std::string nameIn(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t length = sequenceLength(name, at);
    text += length > 0 ? name.substr(at, length) : "?";
    at += std::max<std::size_t>(1, length);
  }
  return text;
}

/// Returns true if two paths name the same file; the file need not exist yet.
bool isSameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error);
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

}  // namespace

InputRecord::InputRecord() {
  assert(!record_of_thread);
  record_of_thread = this;
}

InputRecord::~InputRecord() { record_of_thread = nullptr; }

InputRecord* InputRecord::current() { return record_of_thread; }

void InputRecord::note(const std::string& path, std::string_view bytes) {
  if (std::find(paths_.begin(), paths_.end(), path) != paths_.end()) return;
  paths_.push_back(path);
  inputs_.push_back({{"name", nameIn(path)}, {"bytes", bytes.size()}, {"sha256", sha256Of(bytes)}});
}

void InputRecord::claim(const fs::path& path, const std::string& option) {
  const auto isIt = [&](const std::string& file) { return isSameFile(file, path); };
  if (std::any_of(paths_.begin(), paths_.end(), isIt) && std::none_of(replaceable_.begin(), replaceable_.end(), isIt))
    throw InputError::problem(option, fmt::format("this command reads '{}', which would be overwritten", path.string()),
                              "choose another name");
  for (const auto& [other, by] : outputs_)
    if (by != option && isSameFile(other, path))
      throw InputError::problem(option, fmt::format("{} also writes '{}'", by, path.string()),
                                "choose another name for one of them");
  outputs_.emplace_back(path, option);
}

void claimOutput(const fs::path& path, const std::string& option) {
  if (record_of_thread) record_of_thread->claim(path, option);
}

void noteInput(const std::string& path, std::string_view bytes) {
  if (record_of_thread) record_of_thread->note(path, bytes);
}

void stateOrigin(nlohmann::json& document) {
  if (!document.is_object()) return;
  document.emplace("version", kVersion);
  if (record_of_thread) document.emplace("inputs", record_of_thread->inputs());
}

}  // namespace tubeplan::app
