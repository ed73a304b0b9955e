// The columns of a measurement table that hold measured values. All other columns describe what was read, where, how
// and how accurately.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A number in a column of a kind's own: NAME_UNIT, or NAME if it has no unit.
struct MeasuredColumn {
  const char* name;
  deflection::Quantity quantity;
};

inline constexpr std::array<MeasuredColumn, 3> kPlaceColumns{
    {{"x", deflection::Quantity::kLength}, {"y", deflection::Quantity::kLength}, {"z", deflection::Quantity::kLength}}};

/// Values that must be written down for a reading of a kind.
struct ValueColumns {
  bool has_joints = false;  ///< true: all joints; a tip that rests at a point is measured by its joints alone
  bool has_place = false;   ///< true: x, y, z, which are otherwise the place from which it is measured
  std::vector<MeasuredColumn> numbers;  ///< x, y, z if they are measured, then the kind's own
  int least = 0;                        ///< least number of them that a reading states
};

/// Return the columns of kinds that measure: all of their own numbers; some of them; x, y, z and all of them; x, y, z
/// or else their own; nothing but the joints.
[[nodiscard]] inline ValueColumns allOfOwn(std::span<const MeasuredColumn> own) {
  return {false, false, {own.begin(), own.end()}, static_cast<int>(own.size())};
}
[[nodiscard]] inline ValueColumns someOfOwn(std::span<const MeasuredColumn> own) {
  return {false, false, {own.begin(), own.end()}, 1};
}
[[nodiscard]] inline ValueColumns placeAndOwn(std::span<const MeasuredColumn> own) {
  ValueColumns values{false, true, {kPlaceColumns.begin(), kPlaceColumns.end()}, 0};
  values.numbers.insert(values.numbers.end(), own.begin(), own.end());
  values.least = static_cast<int>(values.numbers.size());
  return values;
}
[[nodiscard]] inline ValueColumns placeOrOwn(std::span<const MeasuredColumn> own) {
  ValueColumns values = placeAndOwn(own);
  values.least = 1;
  return values;
}
[[nodiscard]] inline ValueColumns jointsAlone(std::span<const MeasuredColumn>) { return {true, false, {}, 0}; }

}  // namespace tubeplan::calibration
