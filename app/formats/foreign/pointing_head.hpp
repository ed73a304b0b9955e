// Lines of telescope pointing data, and the head before the observations: option records and the record of the site.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

struct PointingLine {
  int number = 0;
  std::string text;
  std::vector<std::string> fields;
};

/// Returns the lines before END, without empty lines and comments.
[[nodiscard]] std::vector<PointingLine> pointingLines(std::string_view text);

/// Returns true if there is at least one field and all fields are numbers.
[[nodiscard]] bool areAllNumbers(const std::vector<std::string>& fields);

/// Returns true if a line is an option record: ": ALTAZ".
[[nodiscard]] bool isPointingOption(const PointingLine& line);

/// Returns the location of a line for messages: "sky.dat:5".
[[nodiscard]] std::string lineOf(const std::string& file, const PointingLine& line);

/// Returns the sexagesimal angle in `count` fields of a line, which has two or three numbers. The first number has the
/// sign and determines the unit. Throws InputError if the first number exceeds `most`, or if minutes or seconds are out
/// of range.
[[nodiscard]] double sixtiethsIn(const std::string& file, const PointingLine& line, std::size_t from, std::size_t count,
                                 double most);

/// Mount, site and weather from the option records and the record of the site.
struct PointingHead {
  std::optional<bool> is_altaz;
  bool is_without_diurnal = false;
  double latitude = 0;
  std::optional<double> temperature, pressure;
  std::size_t rows_from = 0;  ///< index of the first line with an observation
};

/// Reads the lines between the caption and the observations. Throws InputError for unknown options and records.
[[nodiscard]] PointingHead readPointingHead(const std::vector<PointingLine>& lines, const std::string& file);

}  // namespace tubeplan::app
