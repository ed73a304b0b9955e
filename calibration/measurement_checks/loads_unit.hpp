// Mistake: the loads hung from the tip are not in the unit that their column states (newtons, kilograms or pounds).
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/units_of_columns.hpp"

namespace tubeplan::calibration::mistakes::loads_unit {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  const bool has_load =
      std::ranges::any_of(checked.measurements, [](const Measurement& measurement) { return measurement.load > 0; });
  return has_load ? otherNames(checked.units.forces, checked.units.loads) : std::vector<std::string>{};
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto factor = factorOf(checked.units.forces, checked.units.loads, value);
  if (!factor) return std::nullopt;
  Correction correction{
      "loads", value,
      "the unit of the loads is " + value + ", not " + checked.units.loads.name + " as their column states"};
  correction.change = toEach([factor = *factor](Measurement& measurement) { measurement.load *= factor; });
  return correction;
}

inline MistakeKind kind() { return {"loads", "UNIT", "a unit of force", values, correction}; }

}  // namespace tubeplan::calibration::mistakes::loads_unit
