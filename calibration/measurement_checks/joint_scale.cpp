#include "calibration/measurement_checks/joint_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/measurement_checks/golden_section.hpp"
#include "calibration/measurement_checks/quick_alignment.hpp"
#include "deflection/weights.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

namespace {

constexpr double kTurns = 2.5;        // of a joint at most that is no mistake, where its limits allow less
constexpr double kLeastMotion = 0.2;  // rad that a joint moves among readings, or they are no use
constexpr int kScales = 400;          // tried of each sign, in equal ratios
constexpr int kFiner = 40;            // steps of the golden section
constexpr std::size_t kMostReadings = 60;

struct Range {
  double lowest = 0, highest = 0;
  [[nodiscard]] double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
};

Range rangeOf(const CheckedReadings& checked, int joint) {
  const auto [lowest, highest] =
      std::ranges::minmax(checked.readings, {}, [joint](const Measurement& reading) { return reading.q[joint]; });
  return {lowest.q[joint], highest.q[joint]};
}

/// How well readings fit the drawing with one joint's multiplied; smaller is better.
class ScaledReadings {
 public:
  ScaledReadings(const CheckedReadings& checked, int joint)
      : alignment_(checked.start, deflection::reachOf(checked.start.arm)), joint_(joint) {
    const std::size_t stride = (checked.readings.size() + kMostReadings - 1) / kMostReadings;
    for (std::size_t k = 0; k < checked.readings.size(); k += stride) readings_.push_back(checked.readings[k]);
  }

  double score(double factor, double share) {
    auto scaled = readings_;
    for (auto& reading : scaled) reading.q[joint_] *= factor;
    return alignment_.score(scaled, alignment_.tips(scaled), {.share = share});
  }

  /// The best of a range of factors, both of one sign, and then the best near it.
  double best(double from, double to) {
    const double ratio = std::pow(to / from, 1. / kScales);
    double best = from, least_score = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kScales; ++k)
      if (const double factor = from * std::pow(ratio, k), found = score(factor, kCoarse); found < least_score)
        best = factor, least_score = found;
    return leastOf([&](double factor) { return score(factor, kFine); }, best / ratio, best * ratio, kFiner);
  }

  static constexpr double kCoarse = 1, kFine = 0.01;  // of what counts as no error

 private:
  QuickAlignment alignment_;
  int joint_;
  std::vector<Measurement> readings_;
};

std::vector<std::string> valuesOf(const CheckedReadings& checked) {
  std::vector<std::string> texts;
  const auto joints = jointsBeyondTurns(checked);
  if (joints.size() != 1) return texts;  // likelyScales() finds those of several together
  const int joint = joints.front();
  const Range range = rangeOf(checked, joint);
  const auto& limits = checked.start.arm.joint(joint);
  const double turn = 2 * std::numbers::pi;
  const double most =
      std::min(std::max(std::abs(limits.lower), std::abs(limits.upper)), kTurns * turn) / range.largest();
  const double least = kLeastMotion / (range.highest - range.lowest);
  if (!(least < most)) return texts;
  ScaledReadings scaled(checked, joint);
  for (const int sign : {1, -1})
    texts.push_back(fmt::format("{}:{:.8g}", limits.name, scaled.best(sign * least, sign * most)));
  return texts;
}

std::optional<Mend> mendOf(const CheckedReadings& checked, const std::string& value) {
  const auto [name, number] = partedAtColon(value);
  const int joint = jointNamed(checked.start.arm, name);
  const double factor = tubesheets::parseNumber(number).value_or(0);
  if (joint < 0 || factor == 0) return std::nullopt;
  Mend mend{
      "joint-scale", value,
      fmt::format("the readings of {} are no angles: multiplied by {:.6g} they are, as pulses of an encoder would "
                  "be ({:.6g} to one {})",
                  name, factor, 1 / std::abs(factor), checked.units.angles.name)};
  mend.change = [joint, factor](std::vector<Measurement>& readings) {
    for (auto& reading : readings) reading.q[joint] *= factor;
  };
  mend.numbers_fitted = 1;
  return mend;
}

}  // namespace

std::vector<int> jointsBeyondTurns(const CheckedReadings& checked) {
  std::vector<int> joints;
  if (checked.readings.empty()) return joints;
  const auto& arm = checked.start.arm;
  for (int j = 0; j < arm.jointCount(); ++j) {
    if (arm.joint(j).type != deflection::JointType::kRevolute) continue;
    const double allowed = std::max(std::abs(arm.joint(j).lower), std::abs(arm.joint(j).upper));
    const double largest = rangeOf(checked, j).largest();
    const double turns = 2 * std::numbers::pi * kTurns;
    if (largest > (std::isfinite(allowed) ? std::max(allowed, turns) : 40 * turns)) joints.push_back(j);
  }
  return joints;
}

MistakeKind kind() {
  return {"joint-scale", "JOINT:FACTOR", "a joint and what its readings are to be multiplied by, such as theta2:0.0123",
          valuesOf,      mendOf,         false,
          true};
}

}  // namespace tubeplan::calibration::mistakes::joint_scale
