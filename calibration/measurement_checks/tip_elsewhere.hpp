// Mistake: a tool or target was changed within a set-up, so that another point of the tool is measured from one
// measurement on.
#pragma once

#include <fmt/format.h>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration::mistakes::tip_elsewhere {

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& text) {
  const auto [value, from] = partedAtMeasurement(text);
  const auto& unit = checked.units.coordinates;
  const auto offset = numbersAtColons(value, 3);
  if (!offset || !from) return std::nullopt;
  Correction correction{"tip", value,
                        "the measured point is elsewhere on the tool, by " + value + " " + unit.name +
                            " along its axes: the tool or target was changed there without a set-up of its own"};
  correction.change =
      [by = Eigen::Vector3d(Eigen::Vector3d(offset->data()) * unit.factor)](std::vector<Measurement>& measurements) {
        for (auto& measurement : measurements)
          if (!isDisplacement(measurement) && !measurement.row)
            measurement.p_TQ = measurement.p_TQ.value_or(Eigen::Vector3d::Zero()) + by;
      };
  correction.numbers_fitted = 3;
  return fromMeasurement(checked, std::move(correction), *from);
}

inline std::vector<StepForm> steps(const CheckedMeasurements& checked) {
  StepForm form;
  form.numbers = 3;
  form.slopes = [](const Prediction& prediction) { return prediction.by_numbers; };
  form.value = [&checked](const Eigen::VectorXd& size, const std::string& from) {
    const Eigen::VectorXd shown = size / checked.units.coordinates.factor;
    return fmt::format("{:.5g}:{:.5g}:{:.5g}@{}", shown[0], shown[1], shown[2], from);
  };
  form.is_of_tip = true;
  return {form};
}

inline MistakeKind kind() {
  return {.name = "tip",
          .value = "X:Y:Z@READING",
          .expected =
              "offset of the measured point along the tool's axes, in the unit of the coordinates, and the first such "
              "reading, as in 0:0.5:0@P41",
          .values = noValues,
          .correction = correction,
          .steps = steps};
}

}  // namespace tubeplan::calibration::mistakes::tip_elsewhere
