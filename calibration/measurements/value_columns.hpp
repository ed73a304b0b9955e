// The columns of a measurement table that hold what was measured, by the row of a reading's kind. All others say of
// what, where, how and how well it was read.
#pragma once

#include <array>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

inline constexpr std::array<MeasuredColumn, 3> kPlaceColumns{
    {{"x", deflection::Quantity::kLength}, {"y", deflection::Quantity::kLength}, {"z", deflection::Quantity::kLength}}};

/// What must be written down of a reading of a kind.
struct ValueColumns {
  bool has_joints = false;              ///< every joint's: a tip that rests at a point is measured by its joints alone
  std::vector<MeasuredColumn> numbers;  ///< x, y, z where they are measured, then the kind's own
  int least = 0;                        ///< of the numbers, that a reading states
};

/// Returns whether a kind measures x, y, z, which else are the place of what it is measured from.
[[nodiscard]] inline bool measuresPlace(const MeasurementKindRow& kind) {
  return kind.has_coordinates && !kind.is_touch;
}

/// Returns the columns of a kind; of a way from another reading, which states its coordinates or else its length, both.
[[nodiscard]] inline ValueColumns valueColumnsOf(const MeasurementKindRow& kind) {
  ValueColumns values;
  values.has_joints = kind.is_touch || kind.settle;
  if (measuresPlace(kind)) values.numbers.assign(kPlaceColumns.begin(), kPlaceColumns.end());
  if (kind.is_from_reading) values.least = 1;
  if (!kind.are_columns_given) values.numbers.insert(values.numbers.end(), kind.columns.begin(), kind.columns.end());
  if (!kind.is_from_reading) values.least = kind.is_partly_seen ? 1 : static_cast<int>(values.numbers.size());
  return values;
}

}  // namespace tubeplan::calibration
