// Mistake: the zero of a joint differs from the drawing by more than any misadjustment, for example because the joint
// was homed to another mark or is a quarter turn off.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/from_measurement.hpp"
#include "calibration/measurement_checks/joint_limits.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::joint_zero {

/// Smallest error of a zero that is a mistake instead of a misadjustment [rad]: five times the prior sigma of a joint's
/// offset.
inline constexpr double kLeast = 0.1;

inline std::string textOf(const CheckedMeasurements& checked, int joint, double offset) {
  return fmt::format("{}:{:.6g}", checked.start.arm.joint(joint).name, offset / checked.units.angles.factor);
}

/// Returns the offset [rad] that the value "JOINT:ANGLE" adds to the joint's readings.
inline double zeroOf(const CheckedMeasurements& checked, const std::string& value) {
  return tubesheets::parseNumber(partedAtColon(value).second).value_or(0) * checked.units.angles.factor;
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  for (const int j : turningJoints(checked.start.arm))
    for (const int quarters : {-1, 1, 2}) texts.push_back(textOf(checked, j, quarters * std::numbers::pi / 2));
  for (const int j : turningJoints(checked.start.arm))
    for (const int part : {-1, 1}) texts.push_back(textOf(checked, j, part * std::numbers::pi / 9));
  return texts;
}

/// Returns the values that are tried together with another mistake: offsets of +-15 deg and of multiples of 30 deg. The
/// best of them is refined later, by a fit of the zero.
inline std::vector<std::string> valuesWithOthers(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  for (const int j : turningJoints(checked.start.arm))
    for (const int part : {-10, -8, -6, -4, -2, -1, 1, 2, 4, 6, 8, 10, 12})
      texts.push_back(textOf(checked, j, part * std::numbers::pi / 12));
  return texts;
}

/// Returns a joint reading [rad] wrapped by whole turns into its joint's limits; unchanged if it is within them already
/// or if no number of turns brings it there.
inline double wound(const deflection::Joint<double>& joint, double q) {
  if (!isPastLimit(joint, q)) return q;
  constexpr double kTurn = 2 * std::numbers::pi;
  const double back = q + kTurn * std::ceil((joint.lower - q) / kTurn);
  return isPastLimit(joint, back) ? q : back;
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& text) {
  const auto [value, from] = partedAtMeasurement(text);
  const auto [name, number] = partedAtColon(value);
  const int joint = jointNamed(checked.start.arm, name);
  const auto offset = tubesheets::parseNumber(number);
  if (joint < 0 || !offset) return std::nullopt;
  if (checked.start.arm.joint(joint).type != deflection::JointType::kRevolute) return std::nullopt;
  Correction correction{
      "joint-zero", value,
      "the zero of " + name + " is off: " + number + " " + checked.units.angles.name + " to be added to its readings"};
  correction.change =
      toEach([joint, of = checked.start.arm.joint(joint), by = *offset * checked.units.angles.factor](
                 Measurement& measurement) { measurement.q[joint] = wound(of, measurement.q[joint] + by); });
  correction.numbers_fitted = 1;
  if (from) {
    correction.sentence += "; a turn or counts of its encoder were lost there, or it was hit or homed again";
    return fromMeasurement(checked, std::move(correction), *from);
  }
  correction.zeros_of = {joint};
  return correction;
}

inline std::vector<StepForm> steps(const CheckedMeasurements& checked) {
  std::vector<StepForm> forms;
  for (const int j : turningJoints(checked.start.arm))
    forms.push_back(
        {.numbers = 1,
         .slopes = [j](const Prediction& prediction) { return prediction.by_joints.col(j); },
         .value = [&checked, j](const Eigen::VectorXd& size,
                                const std::string& from) { return textOf(checked, j, size[0]) + "@" + from; }});
  return forms;
}

inline MistakeKind kind() {
  return {"joint-zero",
          "JOINT:ANGLE[@READING]",
          "a revolute joint and the offset to add to its readings, in their unit, and the first such reading, as in "
          "theta3:90 or theta3:8@P41",
          values,
          correction,
          false,
          true,
          valuesWithOthers,
          steps};
}

}  // namespace tubeplan::calibration::mistakes::joint_zero
