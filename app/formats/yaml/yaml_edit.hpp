// Changes of single values of a YAML text that leave everything else, comments and order included, as the user wrote
// it.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the text with the value at a dotted path ("base.position", "links[3].beam.Iz") replaced by `value`: a
/// number, a word, or a map or list in flow style. Missing last keys of the path are added: inside the braces of a flow
/// map, else on a line of their own. The text must be valid for parseYaml, and every list item of the path must exist.
[[nodiscard]] std::string withYamlValue(const std::string& text, std::string_view path, std::string_view value);

/// Returns the text without the existing key at the end of the path and its value. Removal of a map's last key leaves
/// `{}`.
[[nodiscard]] std::string withoutYamlValue(const std::string& text, std::string_view path);

}  // namespace tubeplan::app
