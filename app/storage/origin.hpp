// What a result was made by and of: the program's version, and each file that was read with its SHA-256. And that no
// option writes over one of those, or over what another option writes.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tubeplan::app {

/// Notes the files that the readers read on its thread while it lives: a command has one. No second one meanwhile.
class InputRecord {
 public:
  InputRecord();
  ~InputRecord();
  InputRecord(const InputRecord&) = delete;
  InputRecord& operator=(const InputRecord&) = delete;

  /// Of this thread; null where there is none, as behind a served page.
  [[nodiscard]] static InputRecord* current();

  /// A file as it was read first; for readers.
  void note(const std::string& path, std::string_view bytes);

  /// For writers: throws InputError, naming the option, for a file that was read, unless it may be replaced, and for
  /// one that another option writes. Not for devices and pipes, which are anyone's.
  void claim(const std::filesystem::path& path, const std::string& option);

  /// A file that was read and may be written: of a cell its improvement.
  void allowReplacing(const std::string& path) { replaceable_.push_back(path); }

  /// [{name, bytes, sha256}] in the order of reading; the name without its folder, so that results are the same
  /// wherever the files lie.
  [[nodiscard]] const nlohmann::json& inputs() const { return inputs_; }

 private:
  std::vector<std::string> paths_, replaceable_;
  std::vector<std::pair<std::filesystem::path, std::string>> outputs_;  ///< and their options
  nlohmann::json inputs_ = nlohmann::json::array();
};

/// For readers: notes it where there is a record.
void noteInput(const std::string& path, std::string_view bytes);

/// For writers: InputRecord::claim() where there is a record.
void claimOutput(const std::filesystem::path& path, const std::string& option);

/// Adds `version`, and `inputs` where there is a record, to a document that has not its own.
void stateOrigin(nlohmann::json& document);

}  // namespace tubeplan::app
