// A fault of an input, as a value. The application turns it into its one exception.
#pragma once

#include <string>

namespace tubeplan::tubesheets {

/// One fault of an input, in words that a user can act on.
struct Problem {
  std::string what;      ///< key, hole, step or column at fault
  std::string found;     ///< value found; without an expected one, a sentence of what is wrong
  std::string expected;  ///< value expected; empty unless a value is wrong
  std::string advice;    ///< advice to the user; may be empty
  int line = 0;          ///< line of the text, from 1; 0 if there is no text

  /// Returns "what: found F, expected E; advice" or "what: sentence; advice", preceded by the line if there is one.
  [[nodiscard]] std::string sentence() const {
    const std::string place = line > 0 ? "line " + std::to_string(line) + ": " : "";
    const std::string fault = expected.empty() ? found : "found " + found + ", expected " + expected;
    return place + what + ": " + fault + (advice.empty() ? "" : "; " + advice);
  }
};

}  // namespace tubeplan::tubesheets
