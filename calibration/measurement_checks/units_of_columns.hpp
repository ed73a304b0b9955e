// Functions shared by all mistakes of units: the units that a column may have instead of the stated one, and the
// factors that correct its values.
#pragma once

#include <cmath>
#include <functional>
#include <optional>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes {

inline std::vector<std::string> otherNames(const std::vector<NamedUnit>& units, const NamedUnit& present_unit) {
  std::vector<std::string> names;
  for (const auto& unit : units)
    if (unit.name != present_unit.name) names.push_back(unit.name);
  return names;
}

/// Returns the factor that corrects values which were read in unit `present_unit` but are in the named unit; nullopt if
/// there is no such unit.
inline std::optional<double> factorOf(const std::vector<NamedUnit>& units, const NamedUnit& present_unit,
                                      const std::string& name) {
  for (const auto& unit : units)
    if (unit.name == name) return unit.factor / present_unit.factor;
  return std::nullopt;
}

/// Returns the correction that multiplies by `factor` those sigmas whose columns state the same unit as the
/// coordinates. The correction applies to all axes or, if `axis` is given, to this axis only; a common sigma is then
/// not changed. Empty if there are no such sigmas.
inline std::function<void(std::vector<Measurement>&)> sigmaAlong(const CheckedMeasurements& checked, double factor,
                                                                 std::optional<Eigen::Index> axis = {}) {
  const auto& units = checked.units;
  const bool is_common = !axis && units.sigma_column.name == units.coordinates.name;
  const bool is_by_axis = units.axis_sigma_columns.name == units.coordinates.name;
  if (!is_common && !is_by_axis) return {};
  return [=](std::vector<Measurement>& measurements) {
    for (auto& measurement : measurements) {
      if (is_common) measurement.sigma *= factor;
      if (!is_by_axis || !measurement.sigma_W) continue;
      if (axis)
        (*measurement.sigma_W)[*axis] *= factor;
      else
        *measurement.sigma_W *= factor;
    }
  };
}

}  // namespace tubeplan::calibration::mistakes
