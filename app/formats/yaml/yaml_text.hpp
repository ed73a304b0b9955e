// Names of the user's as YAML text, whatever they hold.
#pragma once

#include <string>

namespace tubeplan::app {

/// In quotes, with escapes where the text needs them.
[[nodiscard]] std::string yamlQuoted(const std::string& text);

/// As it stands where it is a plain word of letters, digits, _ and -, else in quotes.
[[nodiscard]] std::string yamlName(const std::string& name);

}  // namespace tubeplan::app
