// Origin of a result: the program's version, and each input file with its SHA-256. InputRecord also prevents options
// from overwriting an input file or the output of another option.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tubeplan::app {

/// Record of the files that a thread reads during the lifetime of this object; each command creates one. A thread has
/// at most one record at a time.
class InputRecord {
 public:
  InputRecord();
  ~InputRecord();
  InputRecord(const InputRecord&) = delete;
  InputRecord& operator=(const InputRecord&) = delete;

  /// Returns the record of the calling thread; null if there is none, for example in a thread that serves pages.
  [[nodiscard]] static InputRecord* current();

  /// Records a file and its content; if the same path is read again, nothing is recorded. Called by file readers.
  void note(const std::string& path, std::string_view bytes);

  /// Claims a path for output. Throws InputError, naming the option, if the path is an input file that may not be
  /// replaced or the output of another option. Devices and pipes are exempt. Called by file writers.
  void claim(const std::filesystem::path& path, const std::string& option);

  /// Allows overwriting an input file, for example when an improved cell replaces the original.
  void allowReplacing(const std::string& path) { replaceable_.push_back(path); }

  /// Returns [{name, bytes, sha256}] in the order in which the files were read. Names omit folders, so that results do
  /// not depend on the location of the files.
  [[nodiscard]] const nlohmann::json& inputs() const { return inputs_; }

 private:
  std::vector<std::string> paths_, replaceable_;
  /// Output paths, each with the option that claimed it.
  std::vector<std::pair<std::filesystem::path, std::string>> outputs_;
  nlohmann::json inputs_ = nlohmann::json::array();
};

/// Records a file in the calling thread's InputRecord, if there is one. Called by file readers.
void noteInput(const std::string& path, std::string_view bytes);

/// Calls InputRecord::claim() of the calling thread's record, if there is one. Called by file writers.
void claimOutput(const std::filesystem::path& path, const std::string& option);

/// Adds `version` and, if the thread has a record, `inputs` to a JSON object. Existing entries are kept.
void stateOrigin(nlohmann::json& document);

}  // namespace tubeplan::app
