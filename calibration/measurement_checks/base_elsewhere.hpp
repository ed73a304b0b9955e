// Mistake: the base is not at the pose that the cell states as known, or it was displaced between two readings.
#pragma once

#include <algorithm>
#include <cmath>

#include "calibration/measurement_checks/from_reading.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration::mistakes::base_elsewhere {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  const bool is_known = std::ranges::any_of(checked.start.base_poses, &BasePose::is_known);
  return is_known ? std::vector<std::string>{"unknown"} : std::vector<std::string>{};
}

/// Returns the correction that assigns reading `from` and all later readings of its set-up to a new set-up, whose base
/// pose is fitted separately; nullopt if there is no such reading.
inline std::optional<Mend> mendFrom(const CheckedReadings& checked, const std::string& from) {
  const auto first = std::ranges::find(checked.readings, from, &Measurement::id);
  if (first == checked.readings.end()) return std::nullopt;
  Mend mend{"base", "unknown", "the base or the tracker stands elsewhere: it was bumped there, and is found anew"};
  mend.new_setup = NewSetup{first->setup + (first->setup.empty() ? "" : "-") + "from-" + from, first->setup};
  mend.change = toEach([setup = *mend.new_setup](Measurement& reading) {
    if (reading.setup == setup.within) reading.setup = setup.name;
  });
  mend.frees_base = std::ranges::any_of(checked.start.base_poses, &BasePose::is_known);
  mend.numbers_fitted = 6;
  return fromReading(checked, std::move(mend), from);
}

inline std::optional<Mend> mend(const CheckedReadings& checked, const std::string& text) {
  const auto [value, from] = partedAtReading(text);
  if (value != "unknown") return std::nullopt;
  if (from) return mendFrom(checked, *from);
  Mend mend{"base", value, "the base does not stand where the cell says that it is known to stand"};
  mend.frees_base = true;
  return mend;
}

/// Returns one step form per set-up: a displacement of its base. If all readings state a time, the step counts as an
/// effect, since the catalogue of effects then describes it (`base-slip`).
inline std::vector<StepForm> steps(const CheckedReadings& checked) {
  const bool are_timed =
      std::ranges::all_of(checked.readings, [](const auto& m) { return m.conditions.states(Condition::kTime); });
  std::vector<StepForm> forms;
  for (const BasePose& base_pose : checked.start.base_poses)
    forms.push_back({.numbers = 6,
                     .slopes = [](const Prediction& prediction) { return prediction.by_base; },
                     .value = [](const Eigen::VectorXd&, const std::string& from) { return "unknown@" + from; },
                     .setup = base_pose.setup,
                     .is_effect = are_timed});
  return forms;
}

inline MistakeKind kind() {
  return {.name = "base",
          .value = "unknown[@READING]",
          .expected = "unknown: the base pose is fitted with the rest; unknown@P41: from that reading on it is another",
          .values = values,
          .mend = mend,
          .steps = steps};
}

}  // namespace tubeplan::calibration::mistakes::base_elsewhere
