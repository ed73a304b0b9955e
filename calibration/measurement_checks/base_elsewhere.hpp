// A base that is said to be known and stands elsewhere.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::base_elsewhere {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  const bool is_known = std::any_of(checked.start.base_poses.begin(), checked.start.base_poses.end(),
                                    [](const BasePose& base_pose) { return base_pose.is_known; });
  return is_known ? std::vector<std::string>{"unknown"} : std::vector<std::string>{};
}

inline std::optional<Mend> mend(const CheckedReadings&, const std::string& value) {
  if (value != "unknown") return std::nullopt;
  Mend mend{"base", value, "the base does not stand where the cell says that it is known to stand"};
  mend.frees_base = true;
  return mend;
}

inline MistakeKind kind() {
  return {"base", "unknown", "unknown: the base pose is fitted with the rest", values, mend};
}

}  // namespace tubeplan::calibration::mistakes::base_elsewhere
