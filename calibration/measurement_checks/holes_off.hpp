// Mistake: holes were counted from the wrong first row or column, so the hole that each measurement names is one or
// more rows or columns away from the touched hole.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::holes_off {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  const bool names_holes = std::ranges::any_of(
      checked.measurements, [&](const Measurement& measurement) { return isPlacedBySheet(checked, measurement); });
  if (!names_holes) return {};
  return {"R+1", "R-1", "C+1", "C-1"};
}

/// Function that returns the hole that was actually touched if a measurement names the hole `named`; null if the sheet
/// has no hole there.
using OtherHole = std::function<const tubesheets::Tube*(const tubesheets::RowAndColumn& named)>;

/// Returns true if every hole that `other` returns exists on the sheet. A single missing hole refutes the hypothesis,
/// because a tip cannot have touched it.
inline bool allHolesExist(const CheckedMeasurements& checked, const OtherHole& other) {
  return std::ranges::all_of(checked.measurements, [&](const Measurement& measurement) {
    return !isPlacedBySheet(checked, measurement) || other(*tubesheets::parseTubeName(measurement.point)) != nullptr;
  });
}

/// In every measurement that takes its position from a hole, replaces the hole by the one that `other` returns.
inline void rename(const CheckedMeasurements& checked, const OtherHole& other, std::vector<Measurement>& measurements) {
  for (Measurement& measurement : measurements) {
    if (!isPlacedBySheet(checked, measurement)) continue;
    const auto* tube = other(*tubesheets::parseTubeName(measurement.point));
    if (!tube) continue;
    measurement.point = tubesheets::tubeName(tube->row, tube->column);
    measurement.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
  }
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  char way = 0;
  int by = 0, used = 0;
  const bool is_read =
      std::sscanf(value.c_str(), "%c%d%n", &way, &by, &used) == 2 && used == static_cast<int>(value.size());
  if (!is_read || (way != 'R' && way != 'C') || by == 0 || std::abs(by) > 1000 || !checked.sheet) return std::nullopt;
  const int rows = way == 'R' ? by : 0, columns = way == 'C' ? by : 0;
  const OtherHole other = [sheet = checked.sheet, rows, columns](const auto& named) {
    return sheet->find(named.row + rows, named.column + columns);
  };
  if (!allHolesExist(checked, other)) return std::nullopt;
  Correction correction{"holes", value,
                        "the holes' names are " + std::to_string(std::abs(by)) + (way == 'R' ? " row" : " column") +
                            (by > 0 ? " too low" : " too high")};
  correction.change = [checked = &checked, other](std::vector<Measurement>& measurements) {
    rename(*checked, other, measurements);
  };
  return correction;
}

inline MistakeKind kind() {
  return {"holes", "R+1|C-1|...",
          "offset to add to the rows or columns of the holes' names, so that the sheet has them all", values,
          correction};
}

}  // namespace tubeplan::calibration::mistakes::holes_off
