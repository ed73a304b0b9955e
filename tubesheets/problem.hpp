// What is wrong with an input, as a value. The application turns it into its one exception.
#pragma once

#include <string>

namespace tubeplan::tubesheets {

/// One fault of an input, in words a user can act on.
struct Problem {
  std::string what;      ///< which key, hole, step or column
  std::string found;     ///< what it says
  std::string expected;  ///< what it should say
  std::string advice;    ///< what to do; may be empty
  int line = 0;          ///< line of the text, from 1; 0 where there is no text

  /// "what: found F, expected E; advice", with the line in front where there is one.
  [[nodiscard]] std::string sentence() const {
    const std::string place = line > 0 ? "line " + std::to_string(line) + ": " : "";
    return place + what + ": found " + found + ", expected " + expected + (advice.empty() ? "" : "; " + advice);
  }
};

}  // namespace tubeplan::tubesheets
