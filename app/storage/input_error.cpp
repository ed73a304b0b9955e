#include "app/storage/input_error.hpp"

#include <fmt/format.h>

#include "app/storage/utf8.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kLongestQuote = 60;
constexpr std::size_t kLongestPart = 4000;  // largest part of a message [bytes]; file names may be this long

std::string sentence(const std::string& where, const std::string& found, const std::string& expected,
                     const std::string& advice) {
  const std::string core = expected.empty() ? fmt::format("{}: {}", where, found)
                                            : fmt::format("{}: found {}, expected {}", where, found, expected);
  return advice.empty() ? core : core + "; " + advice;
}

/// Returns the text as one line: line breaks and tabs become spaces, and unprintable characters become escapes.
std::string part(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  return printable(text, kLongestPart);
}

}  // namespace

InputError::InputError(std::string where, std::string found, std::string expected, std::string advice)
    : std::runtime_error(sentence(part(where), part(found), part(expected), part(advice))),
      where_(part(std::move(where))),
      found_(part(std::move(found))),
      expected_(part(std::move(expected))),
      advice_(part(std::move(advice))) {}

InputError InputError::problem(std::string where, std::string what, std::string advice) {
  return {std::move(where), std::move(what), "", std::move(advice)};
}

InputError inputErrorOf(const std::filesystem::filesystem_error& error) {
  return InputError::problem(error.path1().string(), error.code().message(),
                             "check the name, the folder and the permissions");
}

std::string inQuotes(std::string_view text) { return "'" + nameInLine(text) + "'"; }

std::string nameInLine(std::string_view name) { return printable(name, kLongestQuote); }

}  // namespace tubeplan::app
