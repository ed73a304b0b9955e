#include "calibration/measurement_checks/joint_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/golden_section.hpp"
#include "deflection/weights.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

namespace {

constexpr double kTurns = 2.5;           // maximum number of turns of a real joint, if its limits do not allow more
constexpr double kLeastMotion = 0.2;     // smallest accepted range of a joint's readings after scaling [rad]
constexpr int kScales = 400;             // number of scales that are tried for each sign, in a geometric series
constexpr int kFiner = 40;               // number of golden-section steps
constexpr std::size_t kMostScaled = 60;  // maximum number of measurements in the comparison
// Values of QuickAlignmentOptions::share while the series is tried, and while its best factor is refined.
constexpr double kCoarse = 1, kFine = 0.01;

/// Returns the factor with the best score between `from` and `to`: the best of a geometric series, refined between its
/// two neighbours.
double bestFactor(ScaledMeasurements& scaled, double from, double to) {
  const double ratio = std::pow(to / from, 1. / kScales);
  double best = from, least_score = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kScales; ++k)
    if (const double factor = from * std::pow(ratio, k), found = scaled.score({factor}, kCoarse); found < least_score)
      best = factor, least_score = found;
  return leastOf([&](double factor) { return scaled.score({factor}, kFine); }, best / ratio, best * ratio, kFiner);
}

std::vector<std::string> valuesOf(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  const auto joints = jointsBeyondTurns(checked);
  if (joints.size() != 1) return texts;  // likelyScales() finds the scales of several joints together
  const int joint = joints.front();
  const JointRange range = rangeOf(checked, joint);
  const auto& limits = checked.start.arm.joint(joint);
  const double turn = 2 * std::numbers::pi;
  const double most =
      std::min(std::max(std::abs(limits.lower), std::abs(limits.upper)), kTurns * turn) / range.largest();
  const double least = kLeastMotion / (range.highest - range.lowest);
  if (!(least < most)) return texts;
  ScaledMeasurements scaled(checked, joints, kMostScaled);
  for (const int sign : {1, -1})
    texts.push_back(fmt::format("{}:{:.8g}", limits.name, bestFactor(scaled, sign * least, sign * most)));
  return texts;
}

std::optional<Correction> correctionOf(const CheckedMeasurements& checked, const std::string& value) {
  const auto [name, number] = partedAtColon(value);
  const int joint = jointNamed(checked.start.arm, name);
  const double factor = tubesheets::parseNumber(number).value_or(0);
  if (joint < 0 || factor == 0) return std::nullopt;
  Correction correction{
      "joint-scale", value,
      fmt::format("the readings of {} are not angles; multiplied by {:.6g} they are, as encoder pulses would be "
                  "({:.6g} for one {})",
                  name, factor, 1 / std::abs(factor), checked.units.angles.name)};
  correction.change = toEach([joint, factor](Measurement& measurement) {
    measurement.q[joint] *= factor;
    if (factor < 0 && !measurement.approach_directions.empty())
      measurement.approach_directions[static_cast<std::size_t>(joint)] *= -1;
  });
  correction.numbers_fitted = 1;
  return correction;
}

}  // namespace

JointRange rangeOf(const CheckedMeasurements& checked, int joint) {
  const auto [lowest, highest] = std::ranges::minmax(
      checked.measurements, {}, [joint](const Measurement& measurement) { return measurement.q[joint]; });
  return {lowest.q[joint], highest.q[joint]};
}

ScaledMeasurements::ScaledMeasurements(const CheckedMeasurements& checked, std::vector<int> joints, std::size_t most)
    : joints_(std::move(joints)), alignment_(checked.start, deflection::reachOf(checked.start.arm)) {
  const std::size_t stride = (checked.measurements.size() + most - 1) / most;
  for (std::size_t k = 0; k < checked.measurements.size(); k += stride)
    measurements_.push_back(checked.measurements[k]);
}

double ScaledMeasurements::score(const std::vector<double>& factors, double share) {
  auto scaled = measurements_;
  for (auto& measurement : scaled)
    for (std::size_t j = 0; j < joints_.size(); ++j) measurement.q[joints_[j]] *= factors[j];
  return alignment_.score(scaled, alignment_.tips(scaled), {.share = share});
}

std::vector<int> jointsBeyondTurns(const CheckedMeasurements& checked) {
  std::vector<int> joints;
  if (checked.measurements.empty()) return joints;
  const auto& arm = checked.start.arm;
  for (const int j : turningJoints(arm)) {
    const double allowed = std::max(std::abs(arm.joint(j).lower), std::abs(arm.joint(j).upper));
    const double largest = rangeOf(checked, j).largest();
    const double turns = 2 * std::numbers::pi * kTurns;
    if (largest > (std::isfinite(allowed) ? std::max(allowed, turns) : 40 * turns)) joints.push_back(j);
  }
  return joints;
}

MistakeKind kind() {
  return {.name = "joint-scale",
          .value = "JOINT:FACTOR",
          .expected = "a joint and the factor for its readings, such as theta2:0.0123",
          .values = valuesOf,
          .correction = correctionOf,
          .joins_itself = true};
}

}  // namespace tubeplan::calibration::mistakes::joint_scale
