// Mistake: holes were counted from the other side. Rows or columns of every named hole are reversed, as on a sheet seen
// from its other face.
#pragma once

#include <cmath>

#include "calibration/measurement_checks/holes_off.hpp"

namespace tubeplan::calibration::mistakes::sheet_mirrored {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  return holes_off::values(checked).empty() ? std::vector<std::string>{} : std::vector<std::string>{"columns", "rows"};
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  if ((value != "rows" && value != "columns") || !checked.sheet) return std::nullopt;
  const holes_off::OtherHole other = [sheet = checked.sheet, of_rows = value == "rows"](const auto& named) {
    return of_rows ? sheet->find(sheet->rows + 1 - named.row, named.column)
                   : sheet->find(named.row, sheet->columns + 1 - named.column);
  };
  if (!holes_off::allHolesExist(checked, other)) return std::nullopt;
  Correction correction{"sheet-mirrored", value,
                        "the sheet is mirrored: its " + value + " are counted from the other side"};
  correction.change = [checked = &checked, other](std::vector<Measurement>& measurements) {
    holes_off::rename(*checked, other, measurements);
  };
  return correction;
}

inline MistakeKind kind() {
  return {"sheet-mirrored", "rows|columns", "rows or columns, if the sheet has all the mirrored holes", values,
          correction};
}

}  // namespace tubeplan::calibration::mistakes::sheet_mirrored
