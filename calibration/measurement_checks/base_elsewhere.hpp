// Mistake: the base is not at the pose that the cell states as known, or it was displaced between two measurements.
#pragma once

#include <algorithm>
#include <cmath>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration::mistakes::base_elsewhere {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  const bool is_known = std::ranges::any_of(checked.start.base_poses, &BasePose::is_known);
  return is_known ? std::vector<std::string>{"unknown"} : std::vector<std::string>{};
}

/// Returns the correction that assigns measurement `from` and all later measurements of its set-up to a new set-up,
/// whose base pose is fitted separately; nullopt if there is no such measurement.
inline std::optional<Correction> correctionFrom(const CheckedMeasurements& checked, const std::string& from) {
  const auto first = std::ranges::find(checked.measurements, from, &Measurement::id);
  if (first == checked.measurements.end()) return std::nullopt;
  Correction correction{"base", "unknown", "the base or the tracker was moved there, and its pose is fitted again"};
  correction.new_setup = NewSetup{first->setup + (first->setup.empty() ? "" : "-") + "from-" + from, first->setup};
  correction.change = toEach([setup = *correction.new_setup](Measurement& measurement) {
    if (measurement.setup == setup.within) measurement.setup = setup.name;
  });
  correction.frees_base = std::ranges::any_of(checked.start.base_poses, &BasePose::is_known);
  correction.numbers_fitted = 6;
  return fromMeasurement(checked, std::move(correction), from);
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& text) {
  const auto [value, from] = partedAtMeasurement(text);
  if (value != "unknown") return std::nullopt;
  if (from) return correctionFrom(checked, *from);
  Correction correction{"base", value, "the base is not at the pose that the cell states as known"};
  correction.frees_base = true;
  return correction;
}

/// Returns one step form per set-up: a displacement of its base. If all measurements state a time, the step is
/// classified as an effect, because the catalogue has an effect for it (`base-slip`).
inline std::vector<StepForm> steps(const CheckedMeasurements& checked) {
  const bool are_timed =
      std::ranges::all_of(checked.measurements, [](const auto& m) { return m.conditions.states(Condition::kTime); });
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
          .expected =
              "unknown: the base pose is fitted with the rest; unknown@P41: another base pose is fitted from that "
              "reading on",
          .values = values,
          .correction = correction,
          .steps = steps};
}

}  // namespace tubeplan::calibration::mistakes::base_elsewhere
