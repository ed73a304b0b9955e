// Effects on joint readings, over the whole table: what they do is the shift of the joints, which is linear in their
// parameters.
#include "deflection/effects/joint_shift.hpp"

#include <gtest/gtest.h>

#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

Posture postureOfCobra() {
  Posture posture;
  posture.q = Eigen::Vector4d(0.3, -0.7, 1.1, 0.5);
  posture.load = 90;
  posture.approach_directions = {1, -1, 1, -1};
  return posture;
}

/// Returns every effect of the table that shifts joints, at each of its places, with all parameters plausible.
std::vector<Effect> effectsOnJoints(const Arm& arm) {
  std::vector<Effect> effects;
  for (const EffectKind& kind : effectKinds()) {
    if (kind.parameters.empty()) continue;
    for (const std::string& at : placeTexts(arm, kind)) {
      Effect effect = makeEffect(arm, kind.name, at).effect;
      if (!shiftsJoints(effect)) continue;
      for (std::size_t v = 0; v < effect.values.size(); ++v) effect.values[v] += kind.parameters[v].plausible;
      effects.push_back(effect);
    }
  }
  return effects;
}

TEST(JointShift, IsAllThatEffectsOnJointReadingsDo) {
  const Arm arm = cobraArm();
  const Posture posture = postureOfCobra();
  const auto effects = effectsOnJoints(arm);
  ASSERT_GT(effects.size(), 20U);
  for (const Effect& effect : effects) {
    Arm with = arm;
    with.effects.push_back(effect);
    Posture shifted = posture;
    shifted.q += JointShift(arm, posture).by(effect);
    const auto expected = solveFlexibleKinematics(with, posture), shape = solveFlexibleKinematics(arm, shifted);
    EXPECT_LT((shape.X_BD.p - expected.X_BD.p).norm(), 1e-9) << textOf(arm, effect);
    EXPECT_LT((shape.X_BD.R - expected.X_BD.R).norm(), 1e-9) << textOf(arm, effect);
  }
}

TEST(JointShift, IsLinearInTheParameters) {
  const Arm arm = cobraArm();
  const Posture posture = postureOfCobra();
  for (const Effect& effect : effectsOnJoints(arm)) {
    const Eigen::VectorXd once = JointShift(arm, posture).by(effect);
    Effect thrice = effect, none = effect;
    for (double& value : thrice.values) value *= 3;
    for (double& value : none.values) value = 0;
    EXPECT_LT((JointShift(arm, posture).by(thrice) - 3 * once).norm(), 1e-15 + 1e-12 * once.norm());
    EXPECT_EQ(JointShift(arm, posture).by(none).norm(), 0) << textOf(arm, effect);
    EXPECT_GT(once.norm(), 0) << textOf(arm, effect);
  }
}

}  // namespace
}  // namespace tubeplan::deflection
