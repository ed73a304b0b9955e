// YAML files, read strictly: one document of maps, lists and plain values, every key once.
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

/// Throws InputError for what readTextFile refuses and for what parseYaml refuses.
[[nodiscard]] YamlFile readYamlFile(const std::string& path);

/// Refused: text that is no YAML, tabs, a key that stands twice, a key that is not a word, tags, anchors and aliases,
/// more than one document, no content. `file` is the name for messages.
[[nodiscard]] YamlNode parseYaml(const std::string& text, const std::string& file);

/// The value at a dotted path ("links[3].beam.Iz"); null where there is none.
[[nodiscard]] const YamlNode* findNode(const YamlNode& root, std::string_view path);

}  // namespace tubeplan::app
