#include "app/formats/yaml/yaml_edit.hpp"

#include <algorithm>
#include <cassert>

#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_scan.hpp"

namespace tubeplan::app {

namespace {

constexpr const char* kFileName = "edited text";

// Returns the index past a plain scalar, which ends at a comment, at the end of the line or, in flow style, at a
// bracket, brace or comma.
std::size_t pastPlain(std::string_view text, const YamlNode& node) {
  if (text.substr(node.begin, node.scalar.size()) == node.scalar) return node.begin + node.scalar.size();
  std::size_t end = std::min(text.find('\n', node.begin), text.size());
  for (std::size_t i = node.begin; i < end; ++i)
    if (startsComment(text, i)) end = i;
  return text.find_last_not_of(" \r", end - 1) + 1;
}

// Returns the index past a block scalar (`|` or `>`), which includes all lines indented more than its key or dash.
std::size_t pastBlockText(std::string_view text, const YamlNode& node) {
  const auto lineStart = [&](std::size_t at) { return at == 0 ? 0 : text.rfind('\n', at - 1) + 1; };
  const bool is_item = node.path.ends_with(']');
  const std::size_t start = lineStart(is_item ? node.begin : node.key_begin);
  const std::size_t column = is_item ? text.find_first_not_of(' ', start) - start : node.key_begin - start;
  std::size_t end = std::min(text.find('\n', node.begin), text.size());
  for (std::size_t line = end + 1; line < text.size();) {
    const std::size_t next = std::min(text.find('\n', line), text.size());
    const std::size_t word = text.find_first_not_of(" \r", line);
    if (word < next && word - line <= column) break;
    if (word < next) end = next;
    line = next + 1;
  }
  return end;
}

// Returns the index directly after the colon of a node's key, where a missing value belongs.
std::size_t afterColon(std::string_view text, const YamlNode& node) {
  const char first = text[node.key_begin];
  const std::size_t key_end = first == '"' || first == '\'' ? pastQuoted(text, node.key_begin) : node.key_begin;
  return text.find(':', key_end) + 1;
}

std::size_t endOf(std::string_view text, const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kNull) return afterColon(text, node);
  if (node.kind == YamlNode::Kind::kScalar) {
    const char first = node.is_quoted && node.begin < text.size() ? text[node.begin] : ' ';
    if (first == '"' || first == '\'') return pastQuoted(text, node.begin);
    return first == '|' || first == '>' ? pastBlockText(text, node) : pastPlain(text, node);
  }
  if (node.is_flow) return pastFlow(text, node.begin);
  return node.items.empty() ? node.begin : endOf(text, node.items.back());
}

std::string replaced(const std::string& text, const YamlNode& node, std::string_view value) {
  const std::size_t end = endOf(text, node);
  if (node.kind == YamlNode::Kind::kNull) return text.substr(0, end) + " " + std::string(value) + text.substr(end);
  // A block collection may start on a line after its key, even after a comment; the replacement follows the key's
  // colon.
  const bool is_item = node.path.ends_with(']');
  const bool is_block_under_key = !node.is_flow && node.kind != YamlNode::Kind::kScalar && !is_item;
  const std::size_t begin = is_block_under_key ? afterColon(text, node) : node.begin;
  return text.substr(0, begin) + (is_block_under_key ? " " : "") + std::string(value) + text.substr(end);
}

std::string appendedToFlow(const std::string& text, const YamlNode& map, const std::string& entry) {
  const std::size_t brace = endOf(text, map) - 1;
  const std::size_t last = text.find_last_not_of(" \n\r", brace - 1);
  const std::string separator = map.items.empty() || text[last] == ',' ? "" : ", ";
  const std::size_t at = map.items.empty() ? brace : endOf(text, map.items.back());
  return text.substr(0, at) + separator + entry + text.substr(at);
}

std::string appendedToBlock(const std::string& text, const YamlNode& map, const std::string& entry) {
  const std::size_t last = endOf(text, map);
  const std::size_t line_end = std::min(text.find('\n', last), text.size());
  const std::size_t indent = static_cast<std::size_t>(map.items.empty() ? map.column - 1 : 0);
  std::size_t column = indent;
  if (!map.items.empty()) {
    const std::size_t key = map.items.front().key_begin;
    const std::size_t line_start = key == 0 ? 0 : text.rfind('\n', key - 1) + 1;
    column = key - line_start;
  }
  return text.substr(0, line_end) + "\n" + std::string(column, ' ') + entry + (line_end == text.size() ? "\n" : "") +
         text.substr(line_end);
}

// Returns a dotted path without its last key; empty for a single key.
std::string_view parentPath(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

}  // namespace

std::string withYamlValue(const std::string& text, std::string_view path, std::string_view value) {
  const YamlNode root = parseYaml(text, kFileName);
  if (const YamlNode* node = findNode(root, path)) return replaced(text, *node, value);
  const std::string_view parent_path = parentPath(path);
  const std::string_view key = parent_path.empty() ? path : path.substr(parent_path.size() + 1);
  assert(!key.empty() && key.find('[') == std::string_view::npos);
  const YamlNode* parent = findNode(root, parent_path);
  const std::string entry = std::string(key) + ": " + std::string(value);
  if (!parent || parent->kind != YamlNode::Kind::kMap) return withYamlValue(text, parent_path, "{" + entry + "}");
  return parent->is_flow ? appendedToFlow(text, *parent, entry) : appendedToBlock(text, *parent, entry);
}

std::string withoutYamlValue(const std::string& text, std::string_view path) {
  const YamlNode root = parseYaml(text, kFileName);
  const YamlNode *node = findNode(root, path), *parent = findNode(root, parentPath(path));
  assert(node && parent && parent->kind == YamlNode::Kind::kMap);
  if (parent->items.size() == 1) return replaced(text, *parent, "{}");
  std::size_t begin = node->key_begin, end = endOf(text, *node);
  if (!parent->is_flow) {  // removes complete lines
    begin = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  } else if (const std::size_t next = text.find_first_not_of(" \n\r", end); text[next] == ',') {
    end = text.find_first_not_of(" \n\r", next + 1);
  } else {
    begin = text.rfind(',', begin);
  }
  return text.substr(0, begin) + text.substr(end);
}

}  // namespace tubeplan::app
