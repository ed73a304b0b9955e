// Strict reader of YAML files: one document of maps, lists and plain values, with unique keys.
#pragma once

#include <string>
#include <string_view>

#include "app/formats/yaml/yaml_node.hpp"

namespace tubeplan::app {

struct YamlFile {
  std::string path;
  std::string text;
  YamlNode root;
};

/// Reads a file. Throws InputError as readTextFile() and parseYaml() do.
[[nodiscard]] YamlFile readYamlFile(const std::string& path);

/// Parses a text; `file` is its name in messages. Throws InputError for text that is no YAML, tabs, a key that occurs
/// twice or is no word, tags, anchors and aliases, more than one document, or no content.
[[nodiscard]] YamlNode parseYaml(const std::string& text, const std::string& file);

/// Returns the value at a dotted path ("links[3].beam.Iz"); null if there is none.
[[nodiscard]] const YamlNode* findNode(const YamlNode& root, std::string_view path);

}  // namespace tubeplan::app
