// Strict reader of YAML files: one document of maps, lists and scalars, with unique keys.
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

/// Reads a YAML file. Throws InputError in the cases of readTextFile() and parseYaml().
[[nodiscard]] YamlFile readYamlFile(const std::string& path);

/// Parses YAML text; messages name the text as `file`. Throws InputError for text that is not YAML, tabs, a duplicate
/// key or a key that is not a word, tags, anchors and aliases, several documents, and a document that is empty or not a
/// map.
[[nodiscard]] YamlNode parseYaml(const std::string& text, const std::string& file);

/// Returns the value at a dotted path ("links[3].beam.Iz"); null if there is none.
[[nodiscard]] const YamlNode* findNode(const YamlNode& root, std::string_view path);

}  // namespace tubeplan::app
