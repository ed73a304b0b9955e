// Mistake: rotations in the roll, pitch and yaw columns are written in another form, such as Euler angles of a
// controller or a rotation vector.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/turn_forms.hpp"

namespace tubeplan::calibration::mistakes::turns_as {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  if (std::ranges::none_of(checked.measurements, statesFrame)) return texts;
  for (const auto& form : deflection::kTurnForms)
    if (form.name != std::string(deflection::kFixedAngles.name)) texts.emplace_back(form.name);
  return texts;
}

inline std::optional<Correction> correction(const CheckedMeasurements&, const std::string& value) {
  const auto form = std::ranges::find(deflection::kTurnForms, value, &deflection::TurnForm::name);
  if (form == deflection::kTurnForms.end() || form == deflection::kTurnForms.begin()) return std::nullopt;
  Correction correction{"turns-as", value,
                        "the numbers under roll, pitch, yaw are turns in the form " + value + " (" + form->words +
                            "), as `readings --orientation " + value + "` takes them"};
  correction.change = toEach([turn = form->turn](Measurement& measurement) {
    if (statesFrame(measurement)) measurement.kind_values = deflection::fixedAnglesOf(turn(measurement.kind_values));
  });
  return correction;
}

inline MistakeKind kind() {
  return {.name = "turns-as",
          .value = "FORM",
          .expected = "the form of the turns under roll, pitch, yaw, such as euler-zyz",
          .values = values,
          .correction = correction,
          .values_with_others = noValues,
          .is_of_turns = true};
}

}  // namespace tubeplan::calibration::mistakes::turns_as
