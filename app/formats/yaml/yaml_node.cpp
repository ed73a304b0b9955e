#include "app/formats/yaml/yaml_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

std::optional<double> parseDouble(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool isNotFinite(std::string_view text) {
  while (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  static constexpr std::string_view kWords[] = {".nan", ".NaN", ".NAN", "nan", "NaN", "NAN",     ".inf",
                                                ".Inf", ".INF", "inf",  "Inf", "INF", "infinity"};
  return std::find(std::begin(kWords), std::end(kWords), text) != std::end(kWords);
}

// Throws InputError for a value that is not a number; for a quoted number, advises to remove the quotes.
[[noreturn]] void failAsNumber(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kScalar && !node.is_quoted && isNotFinite(node.scalar))
    node.fail(node.scalar, "a finite number", "");
  node.fail("a number", node.is_quoted ? "write it without quotes" : "");
}

void checkKnown(const YamlNode& map, const std::vector<std::string>& known) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (std::find(known.begin(), known.end(), map.keys[i]) != known.end()) continue;
    map.items[i].fail("the unknown key " + inQuotes(map.keys[i]), alternatives(known), suggestion(map.keys[i], known));
  }
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

const YamlNode& YamlNode::at(std::string_view key) const {
  if (kind != Kind::kMap) fail("a map with the key " + inQuotes(key));
  if (const YamlNode* node = find(key)) return *node;
  failWithProblem("there is no key " + inQuotes(key), "add it");
}

void YamlNode::expectKeys(const std::vector<std::string>& required, const std::vector<std::string>& optional) const {
  std::vector<std::string> known = required;
  known.insert(known.end(), optional.begin(), optional.end());
  if (kind != Kind::kMap) fail("a map with the keys " + alternatives(known));
  checkKnown(*this, known);
  for (const std::string& key : required) (void)at(key);
}

const std::vector<YamlNode>& YamlNode::list() const {
  if (kind != Kind::kList) fail("a list");
  return items;
}

const std::vector<YamlNode>& YamlNode::list(std::size_t count, const std::string& meaning) const {
  if (kind != Kind::kList || items.size() != count) fail(meaning);
  return items;
}

double YamlNode::number() const {
  const auto value = kind == Kind::kScalar && !is_quoted ? parseDouble(scalar) : std::nullopt;
  if (!value || !std::isfinite(*value)) failAsNumber(*this);
  return *value;
}

int YamlNode::integer(int least, int most) const {
  const double value = number();
  if (value != std::floor(value) || value < least || value > most)
    fail(fmt::format("a whole number from {} to {}", least, most));
  return static_cast<int>(value);
}

bool YamlNode::boolean() const {
  if (kind != Kind::kScalar || is_quoted || (scalar != "true" && scalar != "false")) fail("true or false");
  return scalar == "true";
}

std::string YamlNode::text() const {
  if (kind != Kind::kScalar || scalar.empty()) fail("a string");
  return scalar;
}

std::vector<std::string> YamlNode::texts() const {
  std::vector<std::string> out;
  for (const YamlNode& item : list()) out.push_back(item.text());
  return out;
}

std::string YamlNode::where(const std::string& name) const {
  const std::string place = fmt::format("{}:{}:{}", *file, line, column);
  return name.empty() ? place : fmt::format("{} ({})", place, name);
}

std::string YamlNode::description() const {
  switch (kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kList:
      return fmt::format("a list of {}", items.size());
    case Kind::kMap:
      return "a map";
    case Kind::kScalar:
      break;
  }
  return !is_quoted && parseDouble(scalar) ? scalar : "the text " + inQuotes(scalar);
}

void YamlNode::fail(const std::string& expected, const std::string& advice) const {
  fail(description(), expected, advice);
}

void YamlNode::fail(const std::string& found, const std::string& expected, const std::string& advice) const {
  throw InputError(where(), found, expected, advice);
}

void YamlNode::failWithProblem(const std::string& what, const std::string& advice) const {
  throw InputError::problem(where(), what, advice);
}

}  // namespace tubeplan::app
