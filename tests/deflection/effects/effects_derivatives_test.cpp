// Exact derivatives of arms with effects must agree with central differences: with respect to every parameter of every
// effect, at neutral and typical values, and with respect to joints, load and gravity.
#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"
#include "tests/deflection/random_arms.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns the step of a difference quotient: a hundredth of an effect parameter's largest plausible magnitude, or a
/// small fixed step.
double stepOf(const Arm& arm, const Variable& variable) {
  switch (variable.type) {
    case Variable::Type::kJoint:
    case Variable::Type::kGravityTurn:
      return 1e-4;
    case Variable::Type::kLoad:
      return 0.1;
    case Variable::Type::kParameter:
      break;
  }
  const Effect& effect = arm.effects.at(variable.parameter.effect);
  const EffectParameter& parameter = effectKinds()[effect.kind].parameters[variable.parameter.value];
  return parameter.is_shape ? 0.01 : 0.01 * parameter.plausible;
}

std::vector<Variable> postureVariables(const Arm& arm) {
  std::vector<Variable> variables = jointVariables(arm);
  variables.push_back(Variable::load());
  for (int k = 0; k < 3; ++k) variables.push_back(Variable::gravityTurn(k));
  return variables;
}

std::vector<Variable> effectVariables(const Arm& arm) {
  std::vector<Variable> variables;
  for (const auto& parameter : parametersOf(arm))
    if (parameter.path.effect >= 0) variables.push_back(Variable::number(parameter.path));
  return variables;
}

std::string nameOf(const Arm& arm, const Variable& variable) {
  if (variable.type != Variable::Type::kParameter) return "posture variable " + std::to_string(variable.index);
  const Effect& effect = arm.effects[variable.parameter.effect];
  return textOf(arm, effect) + "." + effectKinds()[effect.kind].parameters[variable.parameter.value].name;
}

/// Returns true if a step might carry a moment across a knee, or across zero at a joint with backlash. The tip has no
/// derivative there.
bool isNearAKink(const Arm& arm, const Posture& posture) {
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  for (const Effect& effect : arm.effects) {
    const std::string name = effectKinds()[effect.kind].name;
    if (name != "stiffening" && name != "lost-motion" && name != "backlash") continue;
    const double moment = std::abs(shape.rows[effect.place.row].moment_L[effect.place.axis]);
    if (std::abs(moment - (name == "backlash" ? 0 : effect.values[1])) < 1) return true;
  }
  return false;
}

Posture smoothPosture(const Arm& arm, std::mt19937_64& random) {
  Posture posture = randomPosture(arm, random);
  for (int n = 0; n < 100 && isNearAKink(arm, posture); ++n) posture = randomPosture(arm, random);
  EXPECT_FALSE(isNearAKink(arm, posture));
  return posture;
}

/// Expects that exact derivatives of the tool frame, or of a row's frame if `row` is given, agree with central
/// differences.
void expectExact(const Arm& arm, const Posture& posture, const std::vector<Variable>& variables, int row = kTool) {
  const auto exact = row == kTool ? differentiateTip(arm, posture, variables, kTight)
                                  : differentiateRow(arm, row, posture, variables, kTight);
  ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged);
  ASSERT_TRUE(exact.position_B.allFinite() && exact.rotation_B.allFinite());
  const double reach = reachOf(arm);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double h = stepOf(arm, variables[k]);
    const Difference d = centralDifference(arm, posture, variables[k], h, row);
    const double size = d.position.norm() + reach * d.rotation.norm();
    const double off =
        (d.position - exact.position_B.col(column)).norm() + reach * (d.rotation - exact.rotation_B.col(column)).norm();
    ASSERT_LE(off, 1e-6 * size + 1e-13 * reach / h)
        << arm.name << ": " << nameOf(arm, variables[k]) << " of row " << row;
  }
}

TEST(EffectsDerivatives, ByEveryNumberAtNeutralValues) {
  std::mt19937_64 random(31);
  for (Arm arm : effectArms()) {
    arm.effects = allEffects(arm);
    for (int n = 0; n < 3; ++n) expectExact(arm, smoothPosture(arm, random), effectVariables(arm));
  }
}

TEST(EffectsDerivatives, ByEveryNumberAndByThePostureAtATypicalSize) {
  std::mt19937_64 random(32);
  for (const Arm& bare : effectArms()) {
    for (const Effect& effect : allEffects(bare)) {
      Arm arm = bare;
      arm.effects = {sized(bare, effect, 0.1)};
      auto variables = effectVariables(arm);
      for (const Variable& variable : postureVariables(arm)) variables.push_back(variable);
      expectExact(arm, smoothPosture(arm, random), variables);
    }
  }
}

TEST(EffectsDerivatives, OfEveryRowsFrame) {
  std::mt19937_64 random(36);
  for (const Arm& bare : effectArms()) {
    Arm arm = bare;
    for (const Effect& effect : allEffects(bare)) arm.effects.push_back(sized(bare, effect, 0.01));
    auto variables = effectVariables(arm);
    for (const Variable& variable : postureVariables(arm)) variables.push_back(variable);
    const Posture posture = smoothPosture(arm, random);
    for (int row = 0; row < static_cast<int>(arm.rows.size()); ++row) expectExact(arm, posture, variables, row);
  }
}

TEST(EffectsDerivatives, WithAllOfThemTogether) {
  std::mt19937_64 random(33);
  for (const Arm& bare : effectArms()) {
    Arm arm = bare;
    for (const Effect& effect : allEffects(bare)) arm.effects.push_back(sized(bare, effect, 0.01));
    for (int n = 0; n < 3; ++n) expectExact(arm, smoothPosture(arm, random), postureVariables(arm));
  }
}

TEST(EffectsDerivatives, WhereMostOfThemAreZero) {
  // The arm and gravity lie in one plane, so many derivatives are zero; they too must agree with central differences.
  Arm arm;
  arm.rows = {originRow("upper", {0, 0, 0}, {0, 0, 0}, JointType::kRevolute),
              originRow("lower", {0.8, 0, 0}, {0, 0, 0}, JointType::kRevolute)};
  for (auto& row : arm.rows) {
    row.joint_stiffness[2] = 4e4;
    row.weight.distributed = 30;
  }
  arm.p_LT = {0.6, 0, 0};
  arm.effects = allEffects(arm);
  std::mt19937_64 random(34);
  for (int n = 0; n < 20; ++n) {
    Posture posture = randomPosture(arm, random);
    posture.gravity_B = -Eigen::Vector3d::UnitY();
    if (isNearAKink(arm, posture)) continue;
    expectExact(arm, posture, effectVariables(arm));
  }
}

TEST(EffectsDerivatives, OfAJointSoSoftThatItTurnsFar) {
  Arm arm = withEffect(rigidCopy(sixAxisArm()), "joint-compliance", "pitch.z", {8e-3});
  for (const char* axis : {"pitch.x", "pitch.y"}) arm = withEffect(arm, "joint-compliance", axis, {4e-3});
  auto variables = effectVariables(arm);
  for (const Variable& variable : postureVariables(arm)) variables.push_back(variable);
  std::mt19937_64 random(35);
  double most = 0;
  for (int n = 0; n < 20; ++n) {
    const Posture posture = randomPosture(arm, random);
    most = std::max(most, solveFlexibleKinematics(arm, posture, kTight).components[0].rotation.norm());
    const auto exact = differentiateTip(arm, posture, variables, kTight);
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const double h = 1e-3 * stepOf(arm, variables[k]);
      const Difference d = centralDifference(arm, posture, variables[k], h);
      const auto column = static_cast<Eigen::Index>(k);
      EXPECT_LE((d.position - exact.position_B.col(column)).norm(), 1e-6 * d.position.norm() + 1e-12 / h);
    }
  }
  EXPECT_GT(most, 0.1);
}

RC_GTEST_PROP(EffectsDerivatives, OfRandomArms, ()) {
  const Arm bare = randomArm();
  Arm arm = bare;
  const auto all = allEffects(bare);
  arm.effects.push_back(sized(bare, all[static_cast<std::size_t>(below(static_cast<int>(all.size())))], 0.05));
  Posture posture = randomPostureOf(arm, 300);
  for (Eigen::Index k = 0; k < posture.q.size(); ++k) posture.approach_directions.push_back(below(3) - 1);
  posture.conditions[Condition::kTemperature] = between(283, 303);
  posture.conditions[Condition::kTime] = between(-1000, 1000);
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  RC_PRE(isModest(arm, shape) && !isNearAKink(arm, posture));
  auto variables = effectVariables(arm);
  for (const Variable& variable : postureVariables(arm)) variables.push_back(variable);
  const auto exact = differentiateTip(arm, posture, variables, kTight);
  RC_ASSERT(exact.kinematics.status == KinematicsStatus::kConverged);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    RC_LOG() << nameOf(arm, variables[k]) << " with " << textOf(arm, arm.effects[0]) << std::endl;
    RC_ASSERT(isExact(arm, posture, exact, k, variables[k], stepOf(arm, variables[k])));
  }
}

TEST(EffectsDerivatives, OfAMeasurementByItsScale) {
  ArmOf<Dual> arm = castArm<Dual>(withEffect(cobraArm(), "scale-error", "measurement", {0.002}));
  arm.effects[0].values[0].derivatives()[3] = 1;
  const Dual scale = measurementScale(arm);
  EXPECT_DOUBLE_EQ(scale.value(), 1.002);
  EXPECT_EQ(scale.derivatives()[3], 1);
}

TEST(EffectsDerivatives, AJointThatHangsInItsGapStaysWhereItIs) {
  // While a pendulum on a joint with clearance hangs freely, the joint's reading must not move the tip.
  Arm arm = cobraArm();
  for (auto& row : arm.rows) row.weight = {};
  arm = withEffect(arm, "backlash", "tool.z", {0.06});
  const Eigen::Vector3d tip = arm.p_LT;
  const double down = -std::numbers::pi / 2 - std::atan2(tip.y(), tip.x());
  Posture posture{Eigen::Vector4d(0.3, 0.5, -0.2, down - 0.3 + 0.002), 50};
  const auto variables = postureVariables(arm);
  const auto exact = differentiateTip(arm, posture, variables, kTight);
  ASSERT_LT(std::abs(exact.kinematics.components.back().gap.z()), 0.03);
  EXPECT_LT(std::abs(exact.kinematics.rows[5].moment_L.z()), 1e-9);
  EXPECT_LE(exact.position_B.col(3).norm(), 1e-9);
  expectExact(arm, posture, variables);
}

}  // namespace
}  // namespace tubeplan::deflection
