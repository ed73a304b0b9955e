// Effects that are the same at every posture become numbers of the arm, for every effect of the catalogue.
#include "deflection/effects/constant_effects.hpp"

#include <set>

#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

std::vector<Arm> armsWithLinkedJoints() {
  std::vector<Arm> arms = effectArms();
  arms.push_back(sixAxisArm());
  arms.back().rows[2].joint.type = JointType::kPassive;
  arms.back().rows[2].joint.follows = {{1, -0.5}};
  return arms;
}

TEST(ConstantEffects, TheArmByNumbersHasTheSamePosesForEveryEffect) {
  std::mt19937_64 random(5);
  for (const Arm& arm : armsWithLinkedJoints())
    for (const Effect& neutral : allEffects(arm)) {
      Arm with = arm;
      with.effects = {sized(arm, neutral, 0.5)};
      const ArmByNumbers by = writeConstantEffects(with);
      ASSERT_EQ(by.written.size() + by.arm.effects.size(), 1U) << textOf(arm, neutral);
      for (int k = 0; k < 4; ++k) {
        const Posture posture = randomPosture(arm, random);
        const auto expected = solveFlexibleKinematics(with, posture), found = solveFlexibleKinematics(by.arm, posture);
        ASSERT_EQ(expected.status, found.status) << textOf(arm, neutral);
        if (expected.status != KinematicsStatus::kConverged) continue;
        EXPECT_NEAR((expected.X_BD.p - found.X_BD.p).norm(), 0, 1e-9) << textOf(arm, neutral);
        EXPECT_NEAR((expected.X_BD.R * expected.R_LT - found.X_BD.R * found.R_LT).norm(), 0, 1e-9)
            << textOf(arm, neutral);
      }
    }
}

TEST(ConstantEffects, GeometryAndOffsetsAreWrittenTogether) {
  const Arm arm = sixAxisArm();
  Arm with = arm;
  std::set<std::string> kinds;
  for (const Effect& neutral : allEffects(arm)) with.effects.push_back(sized(arm, neutral, 0.3));
  for (const std::string& name : writeConstantEffects(with).written) kinds.insert(name.substr(0, name.find('@')));
  EXPECT_EQ(kinds, (std::set<std::string>{"joint-offset", "link-length", "link-twist", "link-lean", "tool-offset",
                                          "tool-turn"}));
}

}  // namespace
}  // namespace tubeplan::deflection
