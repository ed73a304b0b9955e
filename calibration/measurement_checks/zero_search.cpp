#include "calibration/measurement_checks/zero_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "calibration/measurement_checks/joint_zero.hpp"

namespace tubeplan::calibration {

namespace {

/// Returns the name of the arm's parameter for the zero of a joint, such as "forearm.joint.offset".
std::string offsetOf(const deflection::Arm& arm, int joint) {
  const int row = deflection::activeRows(arm)[static_cast<std::size_t>(joint)];
  return arm.rows[static_cast<std::size_t>(row)].name + ".joint.offset";
}

std::optional<Correction> zeroFound(const MistakeTrials& trials, const Correction& from,
                                    const deflection::Arm& fitted) {
  const CheckedMeasurements& checked = trials.checked();
  const int joint = from.zeros_of.front();
  const auto before = deflection::findParameter(checked.start.arm, offsetOf(checked.start.arm, joint)),
             after = deflection::findParameter(fitted, offsetOf(checked.start.arm, joint));
  if (!before || !after) return std::nullopt;
  const double tried = mistakes::joint_zero::zeroOf(checked, from.value);
  double zero = std::remainder(tried + after->value - before->value, 2 * std::numbers::pi);
  constexpr double kQuarter = std::numbers::pi / 2, kNearQuarter = 0.035;
  if (const double rounded = std::round(zero / kQuarter) * kQuarter;
      rounded != 0 && std::abs(zero - rounded) < kNearQuarter)
    zero = rounded;
  if (std::abs(zero) < mistakes::joint_zero::kLeast) return std::nullopt;
  return mistakes::joint_zero::correction(checked, mistakes::joint_zero::textOf(checked, joint, zero));
}

}  // namespace

std::optional<JoinedCorrections> withZerosFound(const MistakeTrials& trials, JoinedCorrections parts) {
  const Correction from = joined(parts);
  if (from.zeros_of.empty()) return parts;
  PlacedArm start = trials.startOf(from);
  if (std::ranges::find(from.zeros_of, 0) != from.zeros_of.end())
    for (auto& base_pose : start.base_poses) base_pose.is_known = true;
  std::vector<std::string> names;
  for (const int joint : from.zeros_of) names.push_back(offsetOf(trials.checked().start.arm, joint));
  const auto best = trials.fitZeros(from, std::move(start), names);
  if (!best.ok) return std::nullopt;
  for (Correction& part : parts) {
    if (part.zeros_of.empty()) continue;
    auto found = zeroFound(trials, part, best.placed.arm);
    if (!found) return std::nullopt;
    part = std::move(*found);
  }
  return parts;
}

}  // namespace tubeplan::calibration
