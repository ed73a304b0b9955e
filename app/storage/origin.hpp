// Origin of a result: the program's version and each input file with its SHA-256. Prevents options from overwriting an
// input file or the output of another option.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tubeplan::app {

/// Record of the files read on its thread during its lifetime, one for each command. A thread has at most one at a
/// time.
class InputRecord {
 public:
  InputRecord();
  ~InputRecord();
  InputRecord(const InputRecord&) = delete;
  InputRecord& operator=(const InputRecord&) = delete;

  /// Returns the record of this thread; null if there is none, as in a served page.
  [[nodiscard]] static InputRecord* current();

  /// Notes a file with its content at its first reading; for readers.
  void note(const std::string& path, std::string_view bytes);

  /// Claims a path for output; for writers. Throws InputError, naming the option, for an input file that may not be
  /// replaced and for an output of another option. Any option may write to devices and pipes.
  void claim(const std::filesystem::path& path, const std::string& option);

  /// Allows writing over an input file, as an improved cell over the original.
  void allowReplacing(const std::string& path) { replaceable_.push_back(path); }

  /// Returns [{name, bytes, sha256}] in the order of reading. Names have no folder, so that results are independent of
  /// the place of the files.
  [[nodiscard]] const nlohmann::json& inputs() const { return inputs_; }

 private:
  std::vector<std::string> paths_, replaceable_;
  std::vector<std::pair<std::filesystem::path, std::string>> outputs_;  ///< output paths with their options
  nlohmann::json inputs_ = nlohmann::json::array();
};

/// Notes a file in the thread's InputRecord, if there is one; for readers.
void noteInput(const std::string& path, std::string_view bytes);

/// Calls InputRecord::claim() of the thread's record, if there is one; for writers.
void claimOutput(const std::filesystem::path& path, const std::string& option);

/// Adds `version`, and `inputs` if there is a record, to a document that has none of its own.
void stateOrigin(nlohmann::json& document);

}  // namespace tubeplan::app
