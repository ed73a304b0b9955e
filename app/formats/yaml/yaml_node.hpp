// Value of a YAML file with its place, so that messages about it can name the line.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Value of a YAML file. Its functions throw InputError with the file, line, column and dotted path.
struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };

  std::shared_ptr<const std::string> file;  ///< name of the file, for messages
  std::string path;                         ///< path: "links[3].beam.Iz"; empty for the whole file
  Kind kind = Kind::kNull;
  int line = 1, column = 1;
  std::size_t begin = 0;      ///< index of the value's first byte in the text
  std::size_t key_begin = 0;  ///< index of its key's first byte, for a value in a map
  bool is_quoted = false;     ///< true for a scalar in quotes, which is text and never a number
  bool is_flow = false;       ///< true for a list in [] or a map in {}
  std::string scalar;
  std::vector<std::string> keys;  ///< keys of a map, one for each item
  std::vector<YamlNode> items;    ///< items of a list or map

  /// Returns the value of a key; null if the map does not have it.
  [[nodiscard]] const YamlNode* find(std::string_view key) const;

  /// Returns the value of a key. Throws InputError if the map does not have it.
  [[nodiscard]] const YamlNode& at(std::string_view key) const;

  /// Throws InputError for a value that is not a map, a key that is in neither list, or a missing required key.
  void expectKeys(const std::vector<std::string>& required, const std::vector<std::string>& optional) const;

  /// Returns the items of a list. Throws InputError for any other value.
  [[nodiscard]] const std::vector<YamlNode>& list() const;

  /// Returns the items of a list. Throws InputError unless there are `count`; `meaning` describes them: "three numbers:
  /// x, y, z".
  [[nodiscard]] const std::vector<YamlNode>& list(std::size_t count, const std::string& meaning) const;

  [[nodiscard]] double number() const;  ///< returns a finite number
  [[nodiscard]] int integer(int least, int most) const;
  [[nodiscard]] bool boolean() const;      ///< returns the value of `true` or `false`
  [[nodiscard]] std::string text() const;  ///< returns a word or phrase that is not empty

  /// Returns the text of each item of a list. Throws InputError for other values.
  [[nodiscard]] std::vector<std::string> texts() const;

  /// Returns "file:line:column (path)", or with another name in place of the path.
  [[nodiscard]] std::string where() const { return where(path); }
  [[nodiscard]] std::string where(const std::string& name) const;

  /// Returns a description of the value: "the text 'abc'", "a list of 2".
  [[nodiscard]] std::string description() const;

  [[noreturn]] void fail(const std::string& expected, const std::string& advice = "") const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected, const std::string& advice) const;

  /// Throws InputError::saying() at this value.
  [[noreturn]] void failSaying(const std::string& what, const std::string& advice = "") const;
};

}  // namespace tubeplan::app
