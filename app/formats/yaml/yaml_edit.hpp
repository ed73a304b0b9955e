// Editor of single values in YAML text. Everything else, including comments and order, is unchanged.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the text with `value` (a scalar, or a map or list in flow style) at a dotted path such as "base.position" or
/// "links[3].beam.Iz". Keys that are missing at the end of the path are added: inside the braces of a flow map,
/// otherwise on a new line. The text must be valid for parseYaml, and every list item of the path must exist.
[[nodiscard]] std::string withYamlValue(const std::string& text, std::string_view path, std::string_view value);

/// Returns the text without the last key of the path and its value; the key must exist. A map that loses its only key
/// becomes `{}`.
[[nodiscard]] std::string withoutYamlValue(const std::string& text, std::string_view path);

}  // namespace tubeplan::app
