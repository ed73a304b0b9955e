// Mistake: the tip was mounted again between set-ups. Each set-up then has a different tip, so the set-ups cannot be
// fitted together.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::setup_alone {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  if (checked.start.base_poses.size() < 2) return {};
  return {checked.start.base_poses.front().setup};
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto& base_poses = checked.start.base_poses;
  if (std::ranges::none_of(base_poses, [&](const BasePose& base_pose) { return base_pose.setup == value; }))
    return std::nullopt;
  Correction correction{
      "setup", value,
      "the tip was remounted between the set-ups: each has its own tip offset and must be fitted separately"};
  correction.change = [value](std::vector<Measurement>& measurements) {
    std::erase_if(measurements, [&](const Measurement& measurement) { return measurement.setup != value; });
  };
  correction.parts_setups = true;
  return correction;
}

inline MistakeKind kind() {
  return {"setup", "NAME", "a set-up of the readings, to be taken alone", values, correction};
}

}  // namespace tubeplan::calibration::mistakes::setup_alone
