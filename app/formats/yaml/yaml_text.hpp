// Names of the user's as YAML text, whatever their characters.
#pragma once

#include <string>

namespace tubeplan::app {

/// Returns a text in quotes, with escapes if needed.
[[nodiscard]] std::string yamlQuoted(const std::string& text);

/// Returns a name unchanged if it is a plain word of letters, digits, _ and -, else in quotes.
[[nodiscard]] std::string yamlName(const std::string& name);

}  // namespace tubeplan::app
