// Lines of telescopes' pointing data, and the head above the observations: options and the record of the site.
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

/// Returns the lines up to END, without empty ones and comments.
[[nodiscard]] std::vector<PointingLine> pointingLines(std::string_view text);

/// Returns true if there are fields and all of them are numbers.
[[nodiscard]] bool areAllNumbers(const std::vector<std::string>& fields);

/// Returns true for an option record: ": ALTAZ".
[[nodiscard]] bool isPointingOption(const PointingLine& line);

/// Returns the place of a line: "sky.dat:5".
[[nodiscard]] std::string lineOf(const std::string& file, const PointingLine& line);

/// Returns the angle of two or three numbers, the first with the sign, in the unit of the first. Throws InputError for
/// a first number beyond `most` and for minutes or seconds out of range.
[[nodiscard]] double sixtiethsIn(const std::string& file, const PointingLine& line, std::size_t from, std::size_t count,
                                 double most);

/// Mount, site and weather from the options and the record of the site.
struct PointingHead {
  std::optional<bool> is_altaz;
  bool is_without_diurnal = false;
  double latitude = 0;
  std::optional<double> temperature, pressure;
  std::size_t rows_from = 0;  ///< index of the first observation
};

/// Reads the lines between the caption and the observations. Throws InputError for unknown options and records.
[[nodiscard]] PointingHead readPointingHead(const std::vector<PointingLine>& lines, const std::string& file);

}  // namespace tubeplan::app
