#include "app/formats/foreign/pointing_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>

#include "app/formats/foreign/sexagesimal.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Returns the fields of a line, which are separated by blanks or, within angles, by colons.
std::vector<std::string> fieldsIn(std::string text) {
  std::ranges::replace(text, ':', ' ');
  std::istringstream words(text);
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

std::string capitals(std::string word) {
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

void takeOptions(const std::string& file, const PointingLine& line, PointingHead& head) {
  static constexpr std::array kHarmless{"ALLSKY", "ROTTEL", "ROTNL", "ROTNR", "ROTCL", "ROTCR"};
  for (const auto& field : line.fields) {
    const std::string word = capitals(field);
    if (word == "EQUAT" || word == "ALTAZ") {
      const bool is_altaz = word == "ALTAZ";
      if (head.is_altaz.value_or(is_altaz) != is_altaz)
        throw InputError::problem(lineOf(file, line), "both ALTAZ and EQUAT are stated",
                                  "keep only the one that is the mount of the readings");
      head.is_altaz = is_altaz;
    } else if (word == "NODA") {
      head.is_without_diurnal = true;
    } else if (std::ranges::find(kHarmless, word) == kHarmless.end()) {
      throw InputError(lineOf(file, line), "the option " + inQuotes(field),
                       fmt::format("EQUAT, ALTAZ, NODA, {}", fmt::join(kHarmless, ", ")),
                       "give apparent places of date and the mount's own readings, and remove the option");
    }
  }
}

/// Reads the record of the site: latitude (d m s), date, temperature [degC] and pressure [hPa]; parameters of
/// refraction may follow.
void takePlace(const std::string& file, const std::vector<PointingLine>& lines, std::size_t k, PointingHead& head) {
  constexpr std::size_t kLatitude = 3, kTemperatureAt = 6, kPressureAt = 7, kMost = 12;
  if (k >= lines.size() || !areAllNumbers(lines[k].fields) || lines[k].fields.size() < kLatitude ||
      lines[k].fields.size() > kMost)
    throw InputError(k < lines.size() ? lineOf(file, lines[k]) : file,
                     k < lines.size() ? inQuotes(lines[k].text) : "nothing below the options",
                     "the latitude in degrees, minutes and seconds, then year, month, day, temperature, pressure");
  const PointingLine& line = lines[k];
  head.latitude = sixtiethsIn(file, line, 0, 3, 90);
  if (line.fields.size() > kTemperatureAt) head.temperature = signedNumber(line.fields[kTemperatureAt]);
  if (line.fields.size() > kPressureAt) head.pressure = signedNumber(line.fields[kPressureAt]);
  if (head.temperature && (*head.temperature < -90 || *head.temperature > 60))
    throw InputError(lineOf(file, line), fmt::format("a temperature of {}", line.fields[kTemperatureAt]),
                     "a temperature in degC from -90 to 60");
  if (head.pressure && (*head.pressure < 0 || *head.pressure > 1100))
    throw InputError(lineOf(file, line), fmt::format("a pressure of {}", line.fields[kPressureAt]),
                     "a pressure in hPa from 0 to 1100", "write 0 if the places already include refraction");
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
                       k == 0 ? fmt::format("a number within {} of zero", most) : "minutes or seconds, 0 to 60");
    parts.push_back(std::abs(*number));
  }
  return sumOfSixtieths(line.fields[from].starts_with('-'), parts);
}

PointingHead readPointingHead(const std::vector<PointingLine>& lines, const std::string& file) {
  PointingHead head;
  std::size_t k = 1;
  for (; k < lines.size() && isPointingOption(lines[k]); ++k) takeOptions(file, lines[k], head);
  takePlace(file, lines, k, head);
  head.rows_from = k + 1;
  return head;
}

}  // namespace tubeplan::app
