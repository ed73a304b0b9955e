#include "app/files/origin.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "app/files/sha256.hpp"
#include "app/files/utf8.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

thread_local InputRecord* record_of_thread = nullptr;

/// A file's name may be any bytes; what is no UTF-8 becomes a question mark, for documents have no other text.
std::string nameIn(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t length = sequenceLength(name, at);
    text += length > 0 ? name.substr(at, length) : "?";
    at += std::max<std::size_t>(1, length);
  }
  return text;
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

void noteInput(const std::string& path, std::string_view bytes) {
  if (record_of_thread) record_of_thread->note(path, bytes);
}

void stateOrigin(nlohmann::json& document) {
  if (!document.is_object()) return;
  document.emplace("version", kVersion);
  if (record_of_thread) document.emplace("inputs", record_of_thread->inputs());
}

}  // namespace tubeplan::app
