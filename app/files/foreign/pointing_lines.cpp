#include "app/files/foreign/pointing_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "app/files/foreign/sexagesimal.hpp"
#include "app/files/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// The fields of a line: apart by blanks, angles also by colons.
std::vector<std::string> fieldsIn(std::string text) {
  std::ranges::replace(text, ':', ' ');
  std::istringstream words(text);
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

}  // namespace

std::vector<PointingLine> pointingLines(std::string_view text) {
  std::vector<PointingLine> lines;
  for (const auto& line : tubesheets::textLines(text)) {
    if (line.text.empty() || line.text.starts_with('!')) continue;
    lines.push_back({line.number, std::string(line.text), fieldsIn(std::string(line.text))});
    if (lines.back().fields == std::vector<std::string>{"END"}) {
      lines.pop_back();
      break;
    }
  }
  return lines;
}

bool areAllNumbers(const std::vector<std::string>& fields) {
  return !fields.empty() && std::ranges::all_of(fields, [](const auto& f) { return signedNumber(f).has_value(); });
}

bool isPointingOption(const PointingLine& line) {
  return line.text.starts_with(':') && !line.fields.empty() &&
         std::isalpha(static_cast<unsigned char>(line.fields[0][0])) != 0;
}

std::string lineOf(const std::string& file, const PointingLine& line) {
  return fmt::format("{}:{}", file, line.number);
}

double sixtiethsIn(const std::string& file, const PointingLine& line, std::size_t from, std::size_t count,
                   double most) {
  std::vector<double> parts;
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = signedNumber(line.fields[from + k]);
    const bool is_fit = number && (k == 0 ? std::abs(*number) <= most : isSixtieth(*number));
    if (!is_fit)
      throw InputError(lineOf(file, line), inQuotes(line.fields[from + k]) + fmt::format(" as number {}", from + k + 1),
                       k == 0 ? fmt::format("no more than {}", most) : "minutes or seconds, 0 to 60");
    parts.push_back(std::abs(*number));
  }
  return sumOfSixtieths(line.fields[from].starts_with('-'), parts);
}

}  // namespace tubeplan::app
