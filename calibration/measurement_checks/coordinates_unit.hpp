// Mistake: coordinates and measured distances are not in the unit that their columns state. Positions looked up in the
// tube sheet are not affected.
#pragma once

#include "calibration/measurement_checks/units_of_columns.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration::mistakes::coordinates_unit {

inline bool areWritten(const CheckedMeasurements& checked, const Measurement& measurement) {
  return measurement.p_W && !isPlacedBySheet(checked, measurement);
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  for (const auto& measurement : checked.measurements)
    if (areWritten(checked, measurement)) return otherNames(checked.units.lengths, checked.units.coordinates);
  return {};
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto factor = factorOf(checked.units.lengths, checked.units.coordinates, value);
  if (!factor) return std::nullopt;
  Correction correction{"coordinates", value,
                        "the unit of the coordinates is " + value + ", not " + checked.units.coordinates.name +
                            " as their columns state"};
  correction.change = toEach([checked = &checked, factor = *factor](Measurement& measurement) {
    if (areWritten(*checked, measurement)) *measurement.p_W *= factor;
    const auto columns = kindOf(measurement).columns;
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k].quantity == deflection::Quantity::kLength)
        measurement.kind_values[static_cast<Eigen::Index>(k)] *= factor;
  });
  correction.change_sigma = sigmaAlong(checked, *factor);
  return correction;
}

inline MistakeKind kind() { return {"coordinates", "UNIT", "a unit of length", values, correction}; }

}  // namespace tubeplan::calibration::mistakes::coordinates_unit
