#include "app/files/origin.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "app/files/sha256.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

thread_local InputRecord* record_of_thread = nullptr;

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
  inputs_.push_back({{"name", std::filesystem::path(path).filename().string()},
                     {"bytes", bytes.size()},
                     {"sha256", sha256Of(bytes)}});
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
