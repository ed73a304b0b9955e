// Conversion of user-defined names, with any characters, to YAML text.
#pragma once

#include <string>

namespace tubeplan::app {

/// Returns the text in double quotes, with escapes where needed.
[[nodiscard]] std::string yamlQuoted(const std::string& text);

/// Returns a name unchanged if it is a plain word of letters, digits, _ and -; otherwise the name in double quotes.
[[nodiscard]] std::string yamlName(const std::string& name);

}  // namespace tubeplan::app
