// Conversion of ASCII letters to lower case; all other bytes are unchanged.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

[[nodiscard]] inline char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = lowerCase(c);
  return lower;
}

}  // namespace tubeplan::app
