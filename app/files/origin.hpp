// What a result was made by and of: the program's version, and each file that was read with its SHA-256.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
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

  /// [{name, bytes, sha256}] in the order of reading; the name without its folder, so that results are the same
  /// wherever the files lie.
  [[nodiscard]] const nlohmann::json& inputs() const { return inputs_; }

 private:
  std::vector<std::string> paths_;
  nlohmann::json inputs_ = nlohmann::json::array();
};

/// For readers: notes it where there is a record.
void noteInput(const std::string& path, std::string_view bytes);

/// Adds `version`, and `inputs` where there is a record, to a document that has not its own.
void stateOrigin(nlohmann::json& document);

}  // namespace tubeplan::app
