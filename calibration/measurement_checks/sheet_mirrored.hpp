// Holes counted from the other side: rows or columns of every named hole the wrong way round, as on a sheet seen from
// its other face.
#pragma once

#include <cmath>

#include "calibration/measurement_checks/holes_off.hpp"

namespace tubeplan::calibration::mistakes::sheet_mirrored {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  return holes_off::values(checked).empty() ? std::vector<std::string>{} : std::vector<std::string>{"columns", "rows"};
}

inline void turnRound(const CheckedReadings& checked, bool of_rows, std::vector<Measurement>& readings) {
  std::erase_if(readings, [&](Measurement& reading) {
    if (!isPlacedBySheet(checked, reading)) return false;
    const auto hole = tubesheets::parseTubeName(reading.point);
    const auto* tube = of_rows ? checked.sheet->find(checked.sheet->rows + 1 - hole->row, hole->column)
                               : checked.sheet->find(hole->row, checked.sheet->columns + 1 - hole->column);
    if (!tube) return true;
    reading.point = "R" + std::to_string(tube->row) + "C" + std::to_string(tube->column);
    reading.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
    return false;
  });
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  if ((value != "rows" && value != "columns") || !checked.sheet) return std::nullopt;
  Mend mend{"sheet-mirrored", value, "the sheet is mirrored: its " + value + " are counted from the other side"};
  mend.change = [checked = &checked, of_rows = value == "rows"](std::vector<Measurement>& readings) {
    turnRound(*checked, of_rows, readings);
  };
  return mend;
}

inline MistakeKind kind() {
  return {"sheet-mirrored", "rows|columns", "rows or columns, in a cell with a tube sheet", values, mend};
}

}  // namespace tubeplan::calibration::mistakes::sheet_mirrored
