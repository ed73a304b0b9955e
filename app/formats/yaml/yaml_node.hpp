// Node of a parsed YAML file with its position in the text, so that messages can name the line.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Value in a YAML file. Its member functions throw InputError with the file, line, column and dotted path of the
/// value.
struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };

  std::shared_ptr<const std::string> file;  ///< name of the file, for messages
  std::string path;                         ///< dotted path: "links[3].beam.Iz"; empty for the root
  Kind kind = Kind::kNull;
  int line = 1, column = 1;
  std::size_t begin = 0;      ///< index of the value's first byte in the text
  std::size_t key_begin = 0;  ///< index of the first byte of the value's key; only for a value in a map
  bool is_quoted = false;     ///< true for a scalar in quotes or in a block (| or >): always text, never a number
  bool is_flow = false;       ///< true for a list or map in flow style: [] or {}
  std::string scalar;
  std::vector<std::string> keys;  ///< keys of a map, in the order of `items`
  std::vector<YamlNode> items;    ///< items of a list, or values of a map

  /// Returns the value at a key of this map; null if the map has no such key.
  [[nodiscard]] const YamlNode* find(std::string_view key) const;

  /// Returns the value at a key of this map. Throws InputError if the map has no such key.
  [[nodiscard]] const YamlNode& at(std::string_view key) const;

  /// Throws InputError if the value is not a map, has a key that is neither required nor optional, or lacks a required
  /// key.
  void expectKeys(const std::vector<std::string>& required, const std::vector<std::string>& optional) const;

  /// Returns the items of a list. Throws InputError for a value that is not a list.
  [[nodiscard]] const std::vector<YamlNode>& list() const;

  /// Returns the items of a list. Throws InputError unless the value is a list of `count` items; `meaning` describes it
  /// in messages: "three numbers: x, y, z".
  [[nodiscard]] const std::vector<YamlNode>& list(std::size_t count, const std::string& meaning) const;

  [[nodiscard]] double number() const;  ///< finite number; throws InputError for any other value
  [[nodiscard]] int integer(int least, int most) const;
  [[nodiscard]] bool boolean() const;      ///< value of `true` or `false`; throws InputError for any other value
  [[nodiscard]] std::string text() const;  ///< text of a nonempty scalar; throws InputError for any other value

  /// Returns the items of a list as strings. Throws InputError unless the value is a list of nonempty scalars.
  [[nodiscard]] std::vector<std::string> texts() const;

  /// Returns the location "file:line:column (path)"; the second overload writes `name` instead of the path.
  [[nodiscard]] std::string where() const { return where(path); }
  [[nodiscard]] std::string where(const std::string& name) const;

  /// Returns a description of the value for messages: "the text 'abc'", "a list of 2".
  [[nodiscard]] std::string description() const;

  [[noreturn]] void fail(const std::string& expected, const std::string& advice = "") const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected, const std::string& advice) const;

  /// Throws InputError::problem() at the location of this value.
  [[noreturn]] void failWithProblem(const std::string& what, const std::string& advice = "") const;
};

}  // namespace tubeplan::app
