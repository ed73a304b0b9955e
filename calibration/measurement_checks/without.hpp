// Correction that excludes readings: duplicates, readings beyond the arm's reach, or a run of readings from a device
// that had stopped updating.
#pragma once

#include "calibration/measurement_checks/from_reading.hpp"

namespace tubeplan::calibration::mistakes::without {

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  const auto ids = idsNamed(checked.readings, value);
  if (ids.empty()) return std::nullopt;
  Mend mend{"without", value,
            ids.size() == 1 ? "reading " + value + " is left out" : "the readings " + value + " are left out"};
  mend.change = [ids](std::vector<Measurement>& readings) {
    std::erase_if(readings, [&](const Measurement& reading) { return ids.contains(reading.id); });
  };
  return mend;
}

inline MistakeKind kind() {
  return {"without", "ID[..ID]", "the id of a reading, or of the first and last of a run, such as 81..95", noValues,
          mend};
}

}  // namespace tubeplan::calibration::mistakes::without
