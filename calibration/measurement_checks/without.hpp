// A reading that does not belong there: twice the same, or out of the arm's reach.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::without {

inline std::vector<std::string> values(const CheckedReadings&) { return {}; }

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  if (std::none_of(checked.readings.begin(), checked.readings.end(),
                   [&](const Measurement& reading) { return reading.id == value; }))
    return std::nullopt;
  Mend mend{"without", value, "reading " + value + " is left out"};
  mend.change = [value](std::vector<Measurement>& readings) {
    std::erase_if(readings, [&](const Measurement& reading) { return reading.id == value; });
  };
  return mend;
}

inline MistakeKind kind() { return {"without", "ID", "the id of a reading", values, mend}; }

}  // namespace tubeplan::calibration::mistakes::without
