// What the mistakes of units share: the names of other units, and the factor from the unit that was written.
#pragma once

#include <cmath>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes {

inline std::vector<std::string> otherNames(const std::vector<NamedUnit>& units, const NamedUnit& own) {
  std::vector<std::string> names;
  for (const auto& unit : units)
    if (unit.name != own.name) names.push_back(unit.name);
  return names;
}

/// By how much numbers taken as `own` are too small if they are in the named unit; nothing where there is no such unit.
inline std::optional<double> factorOf(const std::vector<NamedUnit>& units, const NamedUnit& own,
                                      const std::string& name) {
  for (const auto& unit : units)
    if (unit.name == name) return unit.factor / own.factor;
  return std::nullopt;
}

}  // namespace tubeplan::calibration::mistakes
