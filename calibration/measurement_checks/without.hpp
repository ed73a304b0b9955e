// Correction that excludes measurements: duplicates, measurements beyond the arm's reach, or a run of measurements from
// a device that had stopped updating.
#pragma once

#include "calibration/measurement_checks/from_measurement.hpp"

namespace tubeplan::calibration::mistakes::without {

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto ids = idsNamed(checked.measurements, value);
  if (ids.empty()) return std::nullopt;
  Correction correction{
      "without", value,
      ids.size() == 1 ? "reading " + value + " is left out" : "the readings " + value + " are left out"};
  correction.change = [ids](std::vector<Measurement>& measurements) {
    std::erase_if(measurements, [&](const Measurement& measurement) { return ids.contains(measurement.id); });
  };
  return correction;
}

inline MistakeKind kind() {
  return {"without", "ID[..ID]", "the id of a reading, or of the first and last of a run, such as 81..95", noValues,
          correction};
}

}  // namespace tubeplan::calibration::mistakes::without
