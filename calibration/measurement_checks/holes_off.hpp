// Holes counted from another first row or column: every touch of a named hole was one row or column further.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::holes_off {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  const bool names_holes = std::any_of(checked.readings.begin(), checked.readings.end(),
                                       [&](const Measurement& reading) { return isPlacedBySheet(checked, reading); });
  if (!names_holes) return {};
  return {"R+1", "R-1", "C+1", "C-1"};
}

inline void move(const CheckedReadings& checked, int rows, int columns, std::vector<Measurement>& readings) {
  std::erase_if(readings, [&](Measurement& reading) {
    if (!isPlacedBySheet(checked, reading)) return false;
    const auto hole = tubesheets::parseTubeName(reading.point);
    const auto* tube = checked.sheet->find(hole->row + rows, hole->column + columns);
    if (!tube) return true;
    reading.point = "R" + std::to_string(tube->row) + "C" + std::to_string(tube->column);
    reading.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
    return false;
  });
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  char way = 0;
  int by = 0, used = 0;
  const bool is_read =
      std::sscanf(value.c_str(), "%c%d%n", &way, &by, &used) == 2 && used == static_cast<int>(value.size());
  if (!is_read || (way != 'R' && way != 'C') || by == 0 || std::abs(by) > 1000 || !checked.sheet) return std::nullopt;
  const int rows = way == 'R' ? by : 0, columns = way == 'C' ? by : 0;
  Mend mend{"holes", value,
            "the holes' names are " + std::to_string(std::abs(by)) + (way == 'R' ? " row" : " column") +
                (by > 0 ? " too low" : " too high")};
  mend.change = [checked = &checked, rows, columns](std::vector<Measurement>& readings) {
    move(*checked, rows, columns, readings);
  };
  return mend;
}

inline MistakeKind kind() {
  return {"holes", "R+1|C-1|...",
          "offset to add to the rows or columns of the holes' names, in a cell with a tube sheet", values, mend};
}

}  // namespace tubeplan::calibration::mistakes::holes_off
