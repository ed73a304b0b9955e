// The lines of telescopes' pointing data, and what stands above the observations: options and the record of the place.
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

/// Returns the lines that count, up to END: no empty ones and no comments.
[[nodiscard]] std::vector<PointingLine> pointingLines(std::string_view text);

/// Returns whether fields are numbers and nothing else, one at least.
[[nodiscard]] bool areAllNumbers(const std::vector<std::string>& fields);

/// Returns whether a line is an option record: ": ALTAZ".
[[nodiscard]] bool isPointingOption(const PointingLine& line);

/// Returns "sky.dat:5".
[[nodiscard]] std::string lineOf(const std::string& file, const PointingLine& line);

/// Returns the angle of two or three numbers, of which the first has the sign, in the unit of the first. Throws
/// InputError for a first one beyond `most` and for what are no sixtieths.
[[nodiscard]] double sixtiethsIn(const std::string& file, const PointingLine& line, std::size_t from, std::size_t count,
                                 double most);

/// Mount, place and weather as the options and the record of the place state them.
struct PointingHead {
  std::optional<bool> is_altaz;
  bool is_without_diurnal = false;
  double latitude = 0;
  std::optional<double> temperature, pressure;
  std::size_t rows_from = 0;  ///< index of the first observation
};

/// Returns what the lines behind the caption say. Throws InputError for options and records that are not understood.
[[nodiscard]] PointingHead readPointingHead(const std::vector<PointingLine>& lines, const std::string& file);

}  // namespace tubeplan::app
