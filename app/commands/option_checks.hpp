// Checks of option values, for CLI::Option::check(). For a value that it refuses, a check returns a description of the
// expected value, such as "D, G or V" or "0 to 65535", which completes the error message "found ..., expected ..."
// (command_line_error.hpp).
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Returns a check that the value is one of `words`.
[[nodiscard]] CLI::Validator oneOf(const std::vector<std::string>& words);

/// Returns a check that the value is a number from `least` to `most`.
template <class Number>
[[nodiscard]] CLI::Validator within(Number least, Number most) {
  const CLI::Range range(least, most);
  const std::string limits = fmt::format("{} to {}", least, most);
  return {[range, limits](std::string& word) { return range(word).empty() ? std::string() : limits; },
          range.get_description()};
}

/// Returns a check that the value is a number of zero or more.
[[nodiscard]] CLI::Validator notNegative();

/// Returns a check that the value is a length above zero.
[[nodiscard]] CLI::Validator lengthAboveZero();

/// Returns a check that the value is a seed: an unsigned 64-bit integer.
[[nodiscard]] CLI::Validator seedNumber();

}  // namespace tubeplan::app
