#include "tubesheets/tube_forms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {
namespace {

constexpr std::array<std::string_view, 2> kRowWords{"r", "row"};
constexpr std::array<std::string_view, 7> kColumnWords{"c", "col", "column", "l", "line", "t", "tube"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// A number in a tube's name, with the letters before it, and the other characters in front of those letters.
struct Part {
  std::string mark;  ///< characters other than letters, without blanks
  std::string word;
  int number = 0;

  [[nodiscard]] bool isOf(auto words) const { return std::ranges::find(words, word) != words.end(); }
  [[nodiscard]] bool isBare() const { return word.empty(); }
};

/// Splits the whole text into parts; empty if text follows the last number or a number is invalid.
std::vector<Part> partsOf(std::string_view text) {
  std::vector<Part> parts;
  for (std::size_t at = 0; at < text.size();) {
    Part part;
    for (; at < text.size() && !isDigit(text[at]); ++at) {
      const std::string letter = plainName(text.substr(at, 1));
      if (letter.empty() && !part.word.empty() && text[at] != ' ' && text[at] != '.') return {};
      if (!letter.empty())
        part.word += letter;
      else if (text[at] != ' ' && part.word.empty())
        part.mark += text[at];
    }
    const std::size_t start = at;
    while (at < text.size() && isDigit(text[at])) ++at;
    const auto number = parseInteger(text.substr(start, at - start));
    if (!number || *number < 1 || *number > kLargestTubeNumber) return {};
    part.number = *number;
    parts.push_back(std::move(part));
  }
  return parts;
}

std::optional<int> numberCalled(std::string_view text, auto words) {
  const std::vector<Part> parts = partsOf(text);
  if (parts.size() != 1 || !parts[0].mark.empty() || !(parts[0].isBare() || parts[0].isOf(words))) return std::nullopt;
  return parts[0].number;
}

}  // namespace

std::optional<RowAndColumn> readTubeForm(std::string_view text) {
  const std::vector<Part> parts = partsOf(text);
  if (parts.size() != 2 || !parts[0].mark.empty()) return std::nullopt;
  const Part &first = parts[0], &second = parts[1];
  if (first.isBare() && second.isBare())
    return second.mark == "-" || second.mark == "/" ? std::optional(RowAndColumn{first.number, second.number})
                                                    : std::nullopt;
  if (second.mark.find_first_not_of("-/,_.") != std::string::npos) return std::nullopt;
  if (first.isOf(kRowWords) && second.isOf(kColumnWords)) return RowAndColumn{first.number, second.number};
  if (first.isOf(kColumnWords) && second.isOf(kRowWords)) return RowAndColumn{second.number, first.number};
  return std::nullopt;
}

std::optional<int> readRowNumber(std::string_view text) { return numberCalled(text, kRowWords); }
std::optional<int> readColumnNumber(std::string_view text) { return numberCalled(text, kColumnWords); }

}  // namespace tubeplan::tubesheets
