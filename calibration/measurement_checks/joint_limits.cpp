#include "calibration/measurement_checks/joint_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "calibration/measurement_checks/check_words.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

/// Returns how far a joint reading lies beyond the nearer limit [rad or m]; negative within the limits.
double pastLimit(const deflection::Joint<double>& joint, double q) {
  return std::max(joint.lower - q, q - joint.upper);
}

/// Returns by how much encoder noise may move a joint's reading beyond a limit [rad or m].
double usualNoiseOf(const deflection::Joint<double>& joint) { return 1e-9 + 5 * joint.encoder_sigma; }

/// Returns the indices of measurements beyond a joint's limits; empty unless a turn brings all of them within the
/// limits.
std::vector<std::size_t> measurementsToUnwind(const CheckedMeasurements& checked, int j) {
  const auto& joint = checked.start.arm.joint(j);
  std::vector<std::size_t> past;
  for (std::size_t k = 0; k < checked.measurements.size(); ++k) {
    const double q = checked.measurements[k].q[j];
    if (!isPastLimit(joint, q)) continue;
    if (!shiftedByOneTurn(joint, q)) return {};
    past.push_back(k);
  }
  return past;
}

}  // namespace

bool isPastLimit(const deflection::Joint<double>& joint, double q) {
  constexpr double kHair = 1e-3;  // tolerance as a fraction of the joint's range
  const double range = joint.upper - joint.lower;
  return !(pastLimit(joint, q) <= std::max(usualNoiseOf(joint), std::isfinite(range) ? kHair * range : 0));
}

std::optional<MeasurementCheck> slightlyPastLimits(const CheckedMeasurements& checked) {
  const auto& arm = checked.start.arm;
  std::vector<std::string> excesses;
  for (const auto& measurement : checked.measurements)
    for (int j = 0; j < arm.jointCount(); ++j) {
      const auto& joint = arm.joint(j);
      const double past = pastLimit(joint, measurement.q[j]);
      if (!(past > usualNoiseOf(joint)) || isPastLimit(joint, measurement.q[j])) continue;
      const auto unit = columnUnitOf(checked, j);
      const double limit = measurement.q[j] > joint.upper ? joint.upper : joint.lower;
      excesses.push_back(fmt::format("{} of reading {} by {:.2g} {} (limit {:.6g})", joint.name, measurement.id,
                                     past / unit.factor, unit.name, limit / unit.factor));
    }
  if (excesses.empty()) return std::nullopt;
  return remarkOf("past-limit", "slightly past a joint's limit, and used as read: " + listOf(excesses));
}

std::optional<double> shiftedByOneTurn(const deflection::Joint<double>& joint, double q) {
  if (joint.type != deflection::JointType::kRevolute) return std::nullopt;
  const double back = q > joint.upper ? q - kFullTurn : q + kFullTurn;
  return isPastLimit(joint, back) ? std::nullopt : std::optional(back);
}

std::optional<MeasurementCheck> unwindJoints(CheckedMeasurements& checked) {
  const auto& arm = checked.start.arm;
  std::vector<std::string> unwound;
  for (int j = 0; j < arm.jointCount(); ++j) {
    const auto past = measurementsToUnwind(checked, j);
    if (past.empty()) continue;
    const auto unit = columnUnitOf(checked, j);
    const Measurement& first = checked.measurements[past.front()];
    const double back = *shiftedByOneTurn(arm.joint(j), first.q[j]);
    unwound.push_back(fmt::format("{} of {} (reading {}: {:.6g} is {:.6g} {})", past.size(), arm.joint(j).name,
                                  first.id, first.q[j] / unit.factor, back / unit.factor, unit.name));
    for (const std::size_t k : past)
      checked.measurements[k].q[j] = *shiftedByOneTurn(arm.joint(j), checked.measurements[k].q[j]);
  }
  if (unwound.empty()) return std::nullopt;
  linkReferences(checked.measurements);
  return remarkOf(
      "whole-turn",
      fmt::format("joint readings past their limits are changed by a whole turn, which is the same posture: {}",
                  fmt::join(unwound, ", ")));
}

}  // namespace tubeplan::calibration
