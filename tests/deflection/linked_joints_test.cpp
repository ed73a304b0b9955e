// Joints driven through a linkage must follow their drivers, and the rows of a RigidMounting must be rigid in its
// set-up only.
#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns the Cobra with a linkage in place of the forearm's joint: theta3 = -0.8 theta1 - theta2, plus an offset.
Arm linkedCobra() {
  Arm arm = cobraArm();
  Joint<double>& joint = arm.rows[4].joint;
  joint.type = JointType::kPassive;
  joint.follows = {{2, -0.8}, {3, -1}};
  joint.offset = 0.3;
  arm.rows[2].joint.offset = 0.07;
  arm.rows[3].joint.offset = -0.11;
  return arm;
}

/// Returns the same arm with an independent joint in place of the linkage.
Arm unlinked(Arm arm) {
  arm.rows[4].joint.type = JointType::kRevolute;
  arm.rows[4].joint.follows.clear();
  return arm;
}

Posture unlinked(const Arm& arm, const Posture& posture) {
  Posture own = posture;
  own.q.resize(4);
  const double followed = -0.8 * (posture.q[0] + arm.rows[2].joint.offset) - (posture.q[1] + arm.rows[3].joint.offset);
  own.q << posture.q[0], posture.q[1], followed, posture.q[2];
  return own;
}

Posture anyPosture(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-1, 1);
  Posture posture;
  posture.q = Eigen::Vector3d(angle(random), 1 + 0.5 * angle(random), angle(random));
  posture.load = 60 + 50 * angle(random);
  posture.gravity_B = Eigen::Vector3d(0.3 * angle(random), 0.3 * angle(random), -1).normalized();
  return posture;
}

TEST(LinkedJoints, StandWhereAReadingOfTheirOwnWouldPutThem) {
  std::mt19937_64 random(1);
  const Arm linked = linkedCobra(), own = unlinked(linked);
  ASSERT_TRUE(findProblems(linked).empty());
  ASSERT_EQ(activeRows(linked), (std::vector<int>{2, 3, 5}));
  for (int k = 0; k < 50; ++k) {
    const Posture posture = anyPosture(random);
    const auto a = solveFlexibleKinematics(linked, posture, kTight);
    const auto b = solveFlexibleKinematics(own, unlinked(linked, posture), kTight);
    ASSERT_EQ(a.status, KinematicsStatus::kConverged);
    EXPECT_LE((a.X_BD.p - b.X_BD.p).norm(), 1e-13);
    EXPECT_LE((a.X_BD.R - b.X_BD.R).norm(), 1e-13);
    for (std::size_t row = 0; row < a.rows.size(); ++row) {
      EXPECT_LE((a.rows[row].X_BL.p - b.rows[row].X_BL.p).norm(), 1e-13);
      EXPECT_LE((a.rows[row].moment_L - b.rows[row].moment_L).norm(), 1e-9);
    }
  }
}

std::vector<Variable> allVariables(const Arm& arm) {
  std::vector<Variable> variables = jointVariables(arm);
  for (const auto& parameter : parametersOf(arm)) variables.push_back(Variable::number(parameter.path));
  return variables;
}

void expectDifferences(const Arm& arm, const Posture& posture) {
  const auto variables = allVariables(arm);
  const auto tip = differentiateTip(arm, posture, variables, kTight);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    double h = 1e-4;
    if (variables[k].type == Variable::Type::kParameter) {
      Arm copy = arm;
      const double value = locate(copy, variables[k].parameter);
      if (value != 0) h = std::min(1e-3, 1e-3 * std::abs(value));
      const int field = variables[k].parameter.field;  // -1 for a parameter of an effect
      if (field >= 0 && isStiffness(parameterFields()[static_cast<std::size_t>(field)].quantity)) h = 1e-3 * value;
    }
    const auto difference = centralDifference(arm, posture, variables[k], h);
    const auto column = static_cast<Eigen::Index>(k);
    // Rounding errors of the two solved shapes, 1e-14 m each, divided by the step.
    const double rounding = 2e-14 / h;
    EXPECT_LE((tip.position_B.col(column) - difference.position).norm(), 1e-6 * difference.position.norm() + rounding)
        << k;
  }
}

TEST(LinkedJoints, HaveExactDerivativesWithEffectsAndWithout) {
  std::mt19937_64 random(2);
  Arm arm = linkedCobra();
  for (int k = 0; k < 5; ++k) expectDifferences(arm, anyPosture(random));
  Effect scale = makeEffect(arm, "joint-scale", "theta2").effect;
  scale.values[0] = 0.01;
  arm.effects.push_back(scale);
  for (int k = 0; k < 5; ++k) expectDifferences(arm, anyPosture(random));
}

// An effect that corrects a joint's reading must also move the linkage driven by the joint.
TEST(LinkedJoints, FollowTheTrueAngleOfAJointWhoseReadingIsOff) {
  Arm arm = linkedCobra();
  Posture posture{Eigen::Vector3d(0.2, 0.9, -0.4), 50};
  Effect offset = makeEffect(arm, "joint-offset", "theta2").effect;
  offset.values[0] = 0.02;
  arm.effects.push_back(offset);
  const auto with_effect = solveFlexibleKinematics(arm, posture, kTight);
  arm.effects.clear();
  posture.q[1] += 0.02;
  EXPECT_LE((with_effect.X_BD.p - solveFlexibleKinematics(arm, posture, kTight).X_BD.p).norm(), 1e-13);
}

TEST(LinkedJoints, AreRefusedWhereTheyFollowWhatHasNoReading) {
  Arm arm = linkedCobra();
  arm.rows[4].joint.follows = {{0, 1}};
  EXPECT_FALSE(findProblems(arm).empty());
  arm.rows[4].joint.follows = {{2, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(findProblems(arm).empty());
}

Arm onBench() {
  Arm arm = cobraArm();
  arm.mountings = {{"bench", {0, 1}}};
  return arm;
}

TEST(RigidMountings, LeaveTheirRowsRigidInTheirSetUpAlone) {
  std::mt19937_64 random(3);
  Arm bolted = cobraArm();
  for (const int row : {0, 1}) {
    bolted.rows[static_cast<std::size_t>(row)].joint_stiffness.setConstant(kRigid);
    bolted.rows[static_cast<std::size_t>(row)].beam.reset();
  }
  for (int k = 0; k < 20; ++k) {
    Posture posture = randomPosture(cobraArm(), random);
    const auto mezzanine = solveFlexibleKinematics(cobraArm(), posture, kTight);
    EXPECT_LE((solveFlexibleKinematics(onBench(), posture, kTight).X_BD.p - mezzanine.X_BD.p).norm(), 1e-14);
    const auto bench = solveFlexibleKinematics(bolted, posture, kTight);
    posture.setup = "bench";
    EXPECT_LE((solveFlexibleKinematics(onBench(), posture, kTight).X_BD.p - bench.X_BD.p).norm(), 1e-14);
    EXPECT_GT((bench.X_BD.p - mezzanine.X_BD.p).norm(), 1e-4);
  }
}

TEST(RigidMountings, TakeEffectsOfTheirRowsAwayWithThem) {
  Arm arm = onBench();
  Posture posture{Eigen::Vector4d(0.3, 1, -0.8, 0.4), 100};
  posture.setup = "bench";
  const auto bare = solveFlexibleKinematics(arm, posture, kTight);
  Effect soft = makeEffect(arm, "joint-compliance", "mezzanine-platform.y").effect;
  soft.values[0] = 1e-5;
  arm.effects.push_back(soft);
  EXPECT_LE((solveFlexibleKinematics(arm, posture, kTight).X_BD.p - bare.X_BD.p).norm(), 1e-14);
  posture.setup = "mezzanine";
  const auto with_effect = solveFlexibleKinematics(arm, posture, kTight);
  arm.effects.clear();
  EXPECT_GT((with_effect.X_BD.p - solveFlexibleKinematics(arm, posture, kTight).X_BD.p).norm(), 1e-5);
}

TEST(RigidMountings, HaveExactDerivativesInEverySetUp) {
  const Arm arm = onBench();
  Posture posture{Eigen::Vector4d(0.3, 1, -0.8, 0.4), 100};
  expectDifferences(arm, posture);
  posture.setup = "bench";
  expectDifferences(arm, posture);
  const auto stiffness = findParameter(arm, "mezzanine-platform.joint_stiffness.x");
  const auto tip = differentiateTip(arm, posture, {Variable::number(stiffness->path)}, kTight);
  EXPECT_EQ(tip.position_B.norm(), 0);
}

}  // namespace
}  // namespace tubeplan::deflection
