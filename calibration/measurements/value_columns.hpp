// The columns of a measurement table that hold what was measured. All others say of what, where, how and how well it
// was read.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

/// A number that stands in a column of a kind's own: NAME_UNIT, or NAME where it has no unit.
struct MeasuredColumn {
  const char* name;
  deflection::Quantity quantity;
};

inline constexpr std::array<MeasuredColumn, 3> kPlaceColumns{
    {{"x", deflection::Quantity::kLength}, {"y", deflection::Quantity::kLength}, {"z", deflection::Quantity::kLength}}};

/// What must be written down of a reading of a kind.
struct ValueColumns {
  bool has_joints = false;              ///< every joint's: a tip that rests at a point is measured by its joints alone
  bool has_place = false;               ///< x, y, z, which else are the place of what it is measured from
  std::vector<MeasuredColumn> numbers;  ///< x, y, z where they are measured, then the kind's own
  int least = 0;                        ///< of the numbers, that a reading states
};

/// Return the columns of kinds that measure all of their own numbers; some of them; x, y, z beside all of them; x, y, z
/// or else their own; and nothing but the joints.
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
