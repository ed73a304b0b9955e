#include "app/formats/foreign/sexagesimal.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::parseNumber, tubesheets::trimBlanks;

constexpr std::size_t kMostParts = 3;

/// Signs after degrees or hours, minutes and seconds; each has several notations.
using SixtiethMarks = std::array<std::vector<std::string_view>, kMostParts>;

const SixtiethMarks& marksOf(SixtiethForm form) {
  static const SixtiethMarks kHourMarks{{{"h"}, {"m"}, {"s"}}};
  static const SixtiethMarks kDegreeMarks{
      {{"d", "\u00b0"}, {"'", "m", "\u2032", "\u2019"}, {"\"", "''", "s", "\u2033", "\u201d"}}};
  return form == SixtiethForm::kHours ? kHourMarks : kDegreeMarks;
}

/// Removes an unsigned number from the start of the text and returns the number, or std::nullopt if there is none.
/// Decimals are allowed only if `may_be_broken` is true.
std::optional<double> takeDigits(std::string_view& text, bool may_be_broken) {
  std::size_t length = 0;
  const auto isDigit = [&](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  while (length < text.size() && (isDigit(text[length]) || (may_be_broken && text[length] == '.'))) ++length;
  const auto number = length > 0 && isDigit(text[0]) ? parseNumber(text.substr(0, length)) : std::nullopt;
  text = trimBlanks(text.substr(length));
  return number;
}

std::optional<double> summed(bool is_negative, const std::vector<double>& parts) {
  const bool are_sixtieths = std::all_of(parts.begin() + 1, parts.end(), isSixtieth);
  return are_sixtieths ? std::optional(sumOfSixtieths(is_negative, parts)) : std::nullopt;
}

/// Parses an angle of two or three numbers separated by colons or by blanks.
std::optional<double> parseSeparated(std::string_view text, char between, bool is_negative) {
  std::vector<double> parts;
  for (bool is_last = false; !is_last;) {
    const std::size_t end = std::min(text.find(between), text.size());
    is_last = end == text.size();
    std::string_view part = trimBlanks(text.substr(0, end));
    const auto number = takeDigits(part, is_last);
    if (!number || !part.empty() || parts.size() == kMostParts) return std::nullopt;
    parts.push_back(*number);
    text = is_last ? std::string_view() : trimBlanks(text.substr(end + 1));
  }
  return parts.size() > 1 ? summed(is_negative, parts) : std::nullopt;
}

bool takeMark(std::string_view& text, const std::vector<std::string_view>& marks) {
  for (const std::string_view mark : marks)
    if (text.starts_with(mark) && !(mark == "'" && text.starts_with("''"))) {
      text = trimBlanks(text.substr(mark.size()));
      return true;
    }
  return false;
}

/// Parses an angle of two or three numbers with signs after them; the third sign may be missing.
std::optional<double> parseMarked(std::string_view text, const SixtiethMarks& marks, bool is_negative) {
  std::vector<double> parts;
  while (!text.empty()) {
    const auto number = parts.size() < kMostParts ? takeDigits(text, true) : std::nullopt;
    if (!number) return std::nullopt;
    const bool is_whole = *number == std::floor(*number);
    parts.push_back(*number);
    const bool is_marked = takeMark(text, marks[parts.size() - 1]);
    if (!is_marked && !(parts.size() == kMostParts && text.empty())) return std::nullopt;
    if (!is_whole && !text.empty()) return std::nullopt;
  }
  return parts.size() > 1 ? summed(is_negative, parts) : std::nullopt;
}

}  // namespace

std::optional<double> signedNumber(std::string_view field) {
  return parseNumber(field.starts_with('+') ? field.substr(1) : field);
}

double sumOfSixtieths(bool is_negative, std::span<const double> parts) {
  double value = 0, unit = 1;
  for (const double part : parts) {
    value += part * unit;
    unit /= 60;
  }
  return is_negative ? -value : value;
}

std::optional<Sexagesimal> parseSexagesimal(std::string_view field) {
  std::string with_point(trimBlanks(field));
  if (with_point.find('.') == std::string::npos) std::ranges::replace(with_point, ',', '.');
  std::string_view text = with_point;
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text = trimBlanks(text.substr(1));
  if (const auto value = parseSeparated(text, ':', is_negative)) return Sexagesimal{*value, SixtiethForm::kColons};
  if (const auto value = parseSeparated(text, ' ', is_negative)) return Sexagesimal{*value, SixtiethForm::kBlanks};
  for (const auto form : {SixtiethForm::kHours, SixtiethForm::kDegrees})
    if (const auto value = parseMarked(text, marksOf(form), is_negative)) return Sexagesimal{*value, form};
  return std::nullopt;
}

}  // namespace tubeplan::app
