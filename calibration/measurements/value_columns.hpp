// The columns of a measurement table that hold measured values. All other columns describe the target, the conditions
// and the accuracy of a measurement.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A column specific to a kind, headed NAME_UNIT, or NAME if the value has no unit.
struct MeasuredColumn {
  const char* name;
  deflection::Quantity quantity;
};

inline constexpr std::array<MeasuredColumn, 3> kPlaceColumns{
    {{"x", deflection::Quantity::kLength}, {"y", deflection::Quantity::kLength}, {"z", deflection::Quantity::kLength}}};

/// Values that must be filled in for a measurement of one kind.
struct ValueColumns {
  bool has_joints = false;  ///< true if the joint readings are measured values, for kinds whose tip rests at a point
  /// True if x, y, z are measured values; otherwise they are the point from which the kind measures.
  bool has_place = false;
  std::vector<MeasuredColumn> numbers;  ///< measured columns: x, y, z if measured, then the kind's own columns
  int least = 0;                        ///< smallest number of `numbers` that a measurement must state
};

/// Return the value columns of a kind. In the order of the functions below, the kind measures all of its own columns;
/// some of them; x, y, z and all of its own; x, y, z or else its own; only the joints.
[[nodiscard]] inline ValueColumns allKindColumns(std::span<const MeasuredColumn> kind_columns) {
  return {false, false, {kind_columns.begin(), kind_columns.end()}, static_cast<int>(kind_columns.size())};
}
[[nodiscard]] inline ValueColumns someKindColumns(std::span<const MeasuredColumn> kind_columns) {
  return {false, false, {kind_columns.begin(), kind_columns.end()}, 1};
}
[[nodiscard]] inline ValueColumns placeAndKindColumns(std::span<const MeasuredColumn> kind_columns) {
  ValueColumns values{false, true, {kPlaceColumns.begin(), kPlaceColumns.end()}, 0};
  values.numbers.insert(values.numbers.end(), kind_columns.begin(), kind_columns.end());
  values.least = static_cast<int>(values.numbers.size());
  return values;
}
[[nodiscard]] inline ValueColumns placeOrKindColumns(std::span<const MeasuredColumn> kind_columns) {
  ValueColumns values = placeAndKindColumns(kind_columns);
  values.least = 1;
  return values;
}
[[nodiscard]] inline ValueColumns jointsOnly(std::span<const MeasuredColumn>) { return {true, false, {}, 0}; }

}  // namespace tubeplan::calibration
