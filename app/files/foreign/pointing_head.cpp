#include "app/files/foreign/pointing_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "app/files/foreign/sexagesimal.hpp"
#include "app/files/input_error.hpp"

namespace tubeplan::app {

namespace {

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
        throw InputError(lineOf(file, line), "both ALTAZ and EQUAT", "the one kind of mount that the readings are of");
      head.is_altaz = is_altaz;
    } else if (word == "NODA") {
      head.is_without_diurnal = true;
    } else if (std::ranges::find(kHarmless, word) == kHarmless.end()) {
      throw InputError(lineOf(file, line), "the option " + inQuotes(field),
                       fmt::format("EQUAT, ALTAZ, NODA, {}", fmt::join(kHarmless, ", ")),
                       "give apparent places of date and the mount's own readings, and take the option out");
    }
  }
}

/// Latitude d m s, then the date, temperature [degC] and pressure [hPa] and what else refraction hangs on.
void takePlace(const std::string& file, const std::vector<PointingLine>& lines, std::size_t k, PointingHead& head) {
  constexpr std::size_t kLatitude = 3, kTemperatureAt = 6, kPressureAt = 7, kMost = 12;
  if (k >= lines.size() || !areAllNumbers(lines[k].fields) || lines[k].fields.size() < kLatitude ||
      lines[k].fields.size() > kMost)
    throw InputError(k < lines.size() ? lineOf(file, lines[k]) : file,
                     k < lines.size() ? inQuotes(lines[k].text) : "nothing behind the options",
                     "the latitude as degrees, minutes and seconds, then year, month, day, temperature, pressure");
  const PointingLine& line = lines[k];
  head.latitude = sixtiethsIn(file, line, 0, 3, 90);
  if (line.fields.size() > kTemperatureAt) head.temperature = signedNumber(line.fields[kTemperatureAt]);
  if (line.fields.size() > kPressureAt) head.pressure = signedNumber(line.fields[kPressureAt]);
  if (head.temperature && (*head.temperature < -90 || *head.temperature > 60))
    throw InputError(lineOf(file, line), fmt::format("a temperature of {}", line.fields[kTemperatureAt]),
                     "one in degC");
  if (head.pressure && (*head.pressure < 0 || *head.pressure > 1100))
    throw InputError(lineOf(file, line), fmt::format("a pressure of {}", line.fields[kPressureAt]),
                     "one in hPa, 0 where places are with refraction");
}

}  // namespace

PointingHead readPointingHead(const std::vector<PointingLine>& lines, const std::string& file) {
  PointingHead head;
  std::size_t k = 1;
  for (; k < lines.size() && isPointingOption(lines[k]); ++k) takeOptions(file, lines[k], head);
  takePlace(file, lines, k, head);
  head.rows_from = k + 1;
  return head;
}

}  // namespace tubeplan::app
