#include "app/input_error.hpp"

#include <fmt/format.h>

namespace tubeplan::app {

namespace {

constexpr std::size_t kLongestQuote = 60;

std::string sentence(const std::string& where, const std::string& found, const std::string& expected,
                     const std::string& advice) {
  const std::string core = fmt::format("{}: found {}, expected {}", where, found, expected);
  return advice.empty() ? core : core + "; " + advice;
}

// Whatever came in, a message stays one line.
std::string onOneLine(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  return text;
}

}  // namespace

InputError::InputError(std::string where, std::string found, std::string expected, std::string advice)
    : std::runtime_error(onOneLine(sentence(where, found, expected, advice))),
      where_(std::move(where)),
      found_(std::move(found)),
      expected_(std::move(expected)),
      advice_(std::move(advice)) {}

std::string inQuotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text.substr(0, kLongestQuote)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
      out += fmt::format("\\x{:02X}", byte);
    else
      out += c;
  }
  return out + (text.size() > kLongestQuote ? "...'" : "'");
}

}  // namespace tubeplan::app
