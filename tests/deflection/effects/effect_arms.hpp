// Arms for tests of effects: the Cobra, a six-axis arm with rows placed by origin, and an arm with prismatic joints;
// and effects at neutral or typical values.
#pragma once

#include <gtest/gtest.h>

#include "deflection/effects/effect.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {

inline Row<double> originRow(const std::string& name, const Eigen::Vector3d& position, const Eigen::Vector3d& rpy,
                             JointType type) {
  Row<double> row;
  row.name = name;
  row.placement = Origin<double>{position, rpy};
  row.joint.type = type;
  if (type == JointType::kPassive) return row;
  row.joint.name = "joint-of-" + name;
  row.joint.lower = type == JointType::kRevolute ? -2.5 : 0.05;
  row.joint.upper = type == JointType::kRevolute ? 2.5 : 0.6;
  return row;
}

/// Returns an arm of six revolute joints with rows placed by origin. The rows include springs about each axis, a beam
/// that twists, and lumped weights.
inline Arm sixAxisArm() {
  constexpr double kQuarter = std::numbers::pi / 2;
  Arm arm;
  arm.name = "six-axis";
  const auto turning = JointType::kRevolute;
  arm.rows = {originRow("foot", {0, 0, 0.3}, {0, 0, 0}, turning),
              originRow("shoulder", {0.15, 0, 0.2}, {kQuarter, 0, 0}, turning),
              originRow("elbow", {0.7, 0.02, 0}, {0, 0, 0.1}, turning),
              originRow("roll", {0.2, 0, 0.1}, {0, kQuarter, 0}, turning),
              originRow("pitch", {0.05, 0, 0.4}, {0, -kQuarter, 0.2}, turning),
              originRow("flange", {0.1, 0.03, 0}, {0, kQuarter, 0}, turning)};
  arm.rows[0].joint_stiffness = {2e5, 3e5, kRigid};
  arm.rows[1].joint_stiffness[2] = 8e4;
  arm.rows[2].joint_stiffness[2] = 5e4;
  arm.rows[4].joint_stiffness[0] = 1e4;
  arm.rows[1].beam = Beam<double>{7e10, {kRigid, 4e-7, 4e-7}, 2.6e10, 6e-7, 2};
  for (auto& row : arm.rows) row.weight.distributed = 40;
  arm.rows[3].joint.gear_ratio = 40;
  arm.rows[1].weight.lumps = {{60, {0.3, 0.05, 0.02}}};
  arm.rows[3].weight.end = 30;
  arm.p_LT = {0.02, 0.1, 0.25};
  return arm;
}

/// Returns an arm of a turntable, a sliding mast, a wrist and a slider.
inline Arm mastArm() {
  Arm arm;
  arm.name = "mast";
  arm.rows = {originRow("table", {0, 0, 0.1}, {0, 0, 0}, JointType::kRevolute),
              originRow("mast", {0.4, 0, 0.1}, {0, 1.2, 0}, JointType::kPrismatic),
              originRow("wrist", {0.1, 0, 0.05}, {1.0, 0, 0}, JointType::kRevolute),
              originRow("slider", {0.2, 0.1, 0}, {0, 0.4, 0}, JointType::kPrismatic)};
  arm.rows[0].joint_stiffness = {1e5, 1e5, kRigid};
  arm.rows[1].joint_stiffness[0] = 9e4;
  arm.rows[1].joint.offset = 0.1;
  arm.rows[2].joint_stiffness[2] = 3e4;
  for (auto& row : arm.rows) row.weight.distributed = 50;
  arm.rows[1].weight.end = 40;
  arm.p_LT = {0.1, 0.05, 0.2};
  return arm;
}

inline std::vector<Arm> effectArms() { return {cobraArm(), sixAxisArm(), mastArm()}; }

/// Returns the effect `name` at the place `at` of an arm, with the given values or, if there are none, neutral values.
inline Effect effectAt(const Arm& arm, const std::string& name, const std::string& at,
                       std::vector<double> values = {}) {
  MadeEffect made = makeEffect(arm, name, at);
  EXPECT_EQ(made.status, EffectStatus::kMade) << name << "@" << at << ": " << made.reason;
  if (!values.empty()) {
    EXPECT_EQ(values.size(), made.effect.values.size()) << name;
    made.effect.values = std::move(values);
  }
  return made.effect;
}

inline Arm withEffect(Arm arm, const std::string& name, const std::string& at, std::vector<double> values = {}) {
  arm.effects.push_back(effectAt(arm, name, at, std::move(values)));
  return arm;
}

/// Returns every effect that an arm can have, at neutral values.
inline std::vector<Effect> allEffects(const Arm& arm) {
  std::vector<Effect> effects;
  for (const EffectKind& kind : effectKinds())
    for (const std::string& at : placeTexts(arm, kind)) effects.push_back(effectAt(arm, kind.name, at));
  return effects;
}

/// Returns the effect with each parameter moved from neutral by the fraction `share` of its largest plausible
/// magnitude, except for shape parameters (EffectParameter::is_shape). Signs alternate between parameters that may be
/// negative.
inline Effect sized(const Arm& arm, Effect effect, double share) {
  const auto& parameters = effectKinds()[effect.kind].parameters;
  double sign = 1;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (parameters[k].is_shape) continue;
    const bool one_sided = numberOf(arm, effect, static_cast<int>(k)).lower >= 0;
    effect.values[k] += (one_sided ? 1 : sign) * share * parameters[k].plausible;
    sign = -sign;
  }
  return effect;
}

/// Returns a random posture of an arm, with random values of all conditions that an effect may depend on.
inline Posture randomPosture(const Arm& arm, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Posture posture{randomJoints(arm, random), 180 * unit(random), randomDirection(random)};
  for (int k = 0; k < posture.q.size(); ++k) posture.approach_directions.push_back(static_cast<int>(random() % 3) - 1);
  posture.conditions[Condition::kTemperature] = 283 + 20 * unit(random);
  posture.conditions[Condition::kTime] = -1000 + 2000 * unit(random);
  return posture;
}

}  // namespace tubeplan::deflection
