// Mistake: one coordinate is not in the unit that its column states. Positions looked up in the tube sheet are not
// affected.
#pragma once

#include <string_view>

#include "calibration/measurement_checks/coordinates_unit.hpp"

namespace tubeplan::calibration::mistakes::coordinate_unit {

inline constexpr std::string_view kAxes = "xyz";

/// Returns a change that multiplies one written coordinate by a factor; `checked` must outlive it.
inline auto multiplied(const CheckedMeasurements& checked, std::size_t axis, double factor) {
  return toEach([checked = &checked, axis, factor](Measurement& measurement) {
    if (coordinates_unit::areWritten(*checked, measurement))
      (*measurement.p_W)[static_cast<Eigen::Index>(axis)] *= factor;
  });
}

/// Returns the index of an axis by its name; std::string_view::npos for another name.
inline std::size_t axisNamed(const std::string& name) {
  return name.size() == 1 ? kAxes.find(name.front()) : std::string_view::npos;
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> values;
  for (const auto& unit : coordinates_unit::values(checked))
    for (const char axis : kAxes) values.push_back(std::string(1, axis) + ":" + unit);
  return values;
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto [axis, unit] = partedAtColon(value);
  const std::size_t at = axisNamed(axis);
  const auto factor = factorOf(checked.units.lengths, checked.units.coordinates, unit);
  if (at == std::string_view::npos || !factor) return std::nullopt;
  Correction correction{
      "coordinate-unit", value,
      "the unit of " + axis + " is " + unit + ", not " + checked.units.coordinates.name + " as its column states"};
  correction.change = multiplied(checked, at, *factor);
  correction.change_sigma = sigmaAlong(checked, *factor, static_cast<Eigen::Index>(at));
  return correction;
}

inline MistakeKind kind() {
  return {"coordinate-unit", "AXIS:UNIT", "x, y or z and a unit of length", values, correction, false, true};
}

}  // namespace tubeplan::calibration::mistakes::coordinate_unit
