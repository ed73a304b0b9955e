// Mistake: the sigmas of the readings are not in the unit that their column states. Only the ratio of the errors to the
// sigmas reveals this mistake. It is searched for separately (measurement_checks.cpp), so no values are tried here.
#pragma once

#include "calibration/measurement_checks/units_of_columns.hpp"

namespace tubeplan::calibration::mistakes::sigma_unit {

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  const auto factor = factorOf(checked.units.sigmas, checked.units.sigma, value);
  if (!factor) return std::nullopt;
  Mend mend{"sigma", value,
            "the unit of sigma is " + value + ", not " + checked.units.sigma.name + " as its column says"};
  mend.change = toEach([factor = *factor](Measurement& reading) {
    reading.sigma *= factor;
    if (reading.sigma_W) *reading.sigma_W *= factor;
  });
  return mend;
}

inline MistakeKind kind() { return {"sigma", "UNIT", "a unit of length, mil or um", noValues, mend, true}; }

}  // namespace tubeplan::calibration::mistakes::sigma_unit
