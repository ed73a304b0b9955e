// Mistake: the sigmas of the measurements are not in the unit that their column states. Only the ratio of the errors to
// the sigmas reveals this mistake. It is searched for separately (measurement_checks.cpp), so no values are tried here.
#pragma once

#include "calibration/measurement_checks/units_of_columns.hpp"

namespace tubeplan::calibration::mistakes::sigma_unit {

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto factor = factorOf(checked.units.sigmas, checked.units.sigma, value);
  if (!factor) return std::nullopt;
  Correction correction{
      "sigma", value, "the unit of sigma is " + value + ", not " + checked.units.sigma.name + " as its column states"};
  correction.change = toEach([factor = *factor](Measurement& measurement) {
    measurement.sigma *= factor;
    if (measurement.sigma_W) *measurement.sigma_W *= factor;
  });
  return correction;
}

inline MistakeKind kind() { return {"sigma", "UNIT", "a unit of length, mil or um", noValues, correction, true}; }

}  // namespace tubeplan::calibration::mistakes::sigma_unit
