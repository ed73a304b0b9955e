// Checks of options' values, for CLI::Option::check(). Of a value that it refuses, a check returns what it expects, as
// in "D, G or V" or "0 to 65535"; the error of the command line (command_line_error.hpp) continues "found ...,
// expected".
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Returns the check of a word out of these.
[[nodiscard]] CLI::Validator oneOf(const std::vector<std::string>& words);

/// Returns the check of a number within limits.
template <class Number>
[[nodiscard]] CLI::Validator within(Number least, Number most) {
  const CLI::Range range(least, most);
  const std::string limits = fmt::format("{} to {}", least, most);
  return {[range, limits](std::string& word) { return range(word).empty() ? std::string() : limits; },
          range.get_description()};
}

/// Returns the check of a number of zero or more.
[[nodiscard]] CLI::Validator notNegative();

/// Returns the check of a length above zero.
[[nodiscard]] CLI::Validator lengthAboveZero();

/// Returns the check of a seed: a whole number of 64 bits.
[[nodiscard]] CLI::Validator seedNumber();

}  // namespace tubeplan::app
