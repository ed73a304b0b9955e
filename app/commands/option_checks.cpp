#include "app/commands/option_checks.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

CLI::Validator oneOf(const std::vector<std::string>& words) {
  return {[words](const std::string& word) {
            return std::ranges::find(words, word) != words.end() ? std::string() : alternatives(words);
          },
          fmt::format("{{{}}}", fmt::join(words, ","))};
}

CLI::Validator notNegative() {
  return {[](std::string& word) {
            return CLI::NonNegativeNumber(word).empty() ? std::string() : std::string("a number of zero or more");
          },
          CLI::NonNegativeNumber.get_description()};
}

CLI::Validator lengthAboveZero() {
  return {[](const std::string& word) {
            const auto value = tubesheets::parseNumber(word);
            return value && *value > 0 ? std::string() : std::string("a length above zero");
          },
          ""};
}

CLI::Validator seedNumber() {
  return {[](const std::string& word) {
            const char* const end = word.data() + word.size();
            std::uint64_t value = 0;
            const auto [stop, problem] = std::from_chars(word.data(), end, value);
            return problem == std::errc() && stop == end ? std::string()
                                                         : std::string("a whole number from 0 to 2^64 - 1");
          },
          ""};
}

}  // namespace tubeplan::app
