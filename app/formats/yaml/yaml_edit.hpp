// Changes single values of a YAML text and leaves everything else, comments and order included, as the user wrote it.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// The text with the value at a dotted path ("base.position", "links[3].beam.Iz") replaced by `value`, a number, a word
/// or a map or list in flow style. Where the last keys of the path are missing they are added: inside the braces of a
/// flow map, else on a line of their own. The text must be one that parseYaml accepts, and every list item of the path
/// must exist.
[[nodiscard]] std::string withYamlValue(const std::string& text, std::string_view path, std::string_view value);

/// Returns the text without the key at the end of the path, which must be there, and its value. The last key of a map
/// leaves `{}`.
[[nodiscard]] std::string withoutYamlValue(const std::string& text, std::string_view path);

}  // namespace tubeplan::app
