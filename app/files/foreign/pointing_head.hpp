// What stands above the observations of pointing data: options and the record of the place.
#pragma once

#include <optional>

#include "app/files/foreign/pointing_lines.hpp"

namespace tubeplan::app {

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
