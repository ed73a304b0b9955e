// A value of a YAML file that knows where it stands, so that whatever is wrong with it can be said with its line.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// Everything thrown here is an InputError that names the file, line, column and dotted path.
struct YamlNode {
  enum class Kind { kNull, kScalar, kList, kMap };

  std::shared_ptr<const std::string> file;  ///< its name, for messages
  std::string path;                         ///< "links[3].beam.Iz"; empty for the whole file
  Kind kind = Kind::kNull;
  int line = 1, column = 1;
  std::size_t begin = 0;      ///< where the value starts in the text
  std::size_t key_begin = 0;  ///< where its key starts, of a value in a map
  bool is_quoted = false;     ///< a scalar in quotes is text, never a number
  bool is_flow = false;       ///< a list in [] or a map in {}
  std::string scalar;
  std::vector<std::string> keys;  ///< of a map, one for each item
  std::vector<YamlNode> items;    ///< of a list or map

  /// That value of a map; null where the map has no such key.
  [[nodiscard]] const YamlNode* find(std::string_view key) const;

  /// That value of a map. Throws where there is none.
  [[nodiscard]] const YamlNode& at(std::string_view key) const;

  /// Throws for a value that is not a map, a key that is in neither list, a required key that is missing.
  void expectKeys(const std::vector<std::string>& required, const std::vector<std::string>& optional) const;

  /// The items of a list. Throws for anything else.
  [[nodiscard]] const std::vector<YamlNode>& list() const;

  /// Of exactly that many items; `meaning` says which: "three numbers: x, y, z".
  [[nodiscard]] const std::vector<YamlNode>& list(std::size_t count, const std::string& meaning) const;

  [[nodiscard]] double number() const;  ///< finite
  [[nodiscard]] int integer(int least, int most) const;
  [[nodiscard]] bool boolean() const;      ///< true or false, nothing else
  [[nodiscard]] std::string text() const;  ///< one word or phrase, not empty

  /// The text of each item of a list.
  [[nodiscard]] std::vector<std::string> texts() const;

  /// "file:line:column (path)", or with another name for the place.
  [[nodiscard]] std::string where() const { return where(path); }
  [[nodiscard]] std::string where(const std::string& name) const;

  /// "the text 'abc'", "a list of 2".
  [[nodiscard]] std::string description() const;

  [[noreturn]] void fail(const std::string& expected, const std::string& advice = "") const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected, const std::string& advice) const;
};

}  // namespace tubeplan::app
