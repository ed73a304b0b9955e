// An error in an input, as a value. The application converts it to its exception type.
#pragma once

#include <string>

namespace tubeplan::tubesheets {

/// One error in an input, described so that the user can correct it.
struct Problem {
  std::string what;      ///< key, hole, step or column with the error
  std::string found;     ///< value found; if `expected` is empty, a sentence that states the problem
  std::string expected;  ///< value expected; empty unless a value is wrong
  std::string advice;    ///< advice to the user; may be empty
  int line = 0;          ///< line number in the text, from 1; 0 if there is no text

  /// Returns "what: found F, expected E; advice" or "what: sentence; advice", preceded by "line N: " if the line is
  /// known.
  [[nodiscard]] std::string sentence() const {
    const std::string place = line > 0 ? "line " + std::to_string(line) + ": " : "";
    const std::string fault = expected.empty() ? found : "found " + found + ", expected " + expected;
    return place + what + ": " + fault + (advice.empty() ? "" : "; " + advice);
  }
};

}  // namespace tubeplan::tubesheets
