// A tip that was mounted anew between set-ups: each set-up has a tip of its own, so that they cannot be fitted
// together.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::setup_alone {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  if (checked.start.placings.size() < 2) return {};
  return {checked.start.placings.front().setup};
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& value) {
  const auto& placings = checked.start.placings;
  if (std::none_of(placings.begin(), placings.end(), [&](const Placing& placing) { return placing.setup == value; }))
    return std::nullopt;
  Mend mend{"setup", value,
            "the tip was mounted anew between the set-ups: each has a tip of its own and is to be fitted alone"};
  mend.apply = [value](std::vector<Measurement>& readings) {
    std::erase_if(readings, [&](const Measurement& reading) { return reading.setup != value; });
  };
  mend.parts_setups = true;
  return mend;
}

inline MistakeKind kind() { return {"setup", "NAME", "a set-up of the readings, to be taken alone", values, mend}; }

}  // namespace tubeplan::calibration::mistakes::setup_alone
