// Shapes under a force and moment on the tip must agree with closed forms, and their derivatives with difference
// quotients. A wrench must not affect later solutions.
#include <gtest/gtest.h>

#include "deflection/effects/rigid_moment.hpp"
#include "deflection/prepared_arm.hpp"
#include "deflection/tip_differentiation.hpp"
#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

Wrench randomWrench(std::mt19937_64& random, double force, double moment) {
  std::uniform_real_distribution<double> size(0, 1);
  return {force * size(random) * randomDirection(random), moment * size(random) * randomDirection(random)};
}

TEST(Wrench, AlongGravityIsALoad) {
  std::mt19937_64 random(31);
  for (const Arm& arm : effectArms()) {
    for (int n = 0; n < 20; ++n) {
      Posture with_load = randomPosture(arm, random), with_wrench = with_load;
      with_wrench.load = 0;
      with_wrench.wrench = Wrench{with_load.load * with_load.gravity_B};
      const auto one = solveFlexibleKinematics(arm, with_load, kTight),
                 other = solveFlexibleKinematics(arm, with_wrench, kTight);
      ASSERT_EQ(other.status, KinematicsStatus::kConverged) << arm.name;
      EXPECT_LE((one.X_BD.p - other.X_BD.p).norm(), 1e-12 * reachOf(arm)) << arm.name;
      EXPECT_LE((one.rows[0].moment_B - other.rows[0].moment_B).norm(), 1e-9 * (1 + one.rows[0].moment_B.norm()));
    }
  }
}

TEST(Wrench, MomentBendsAndTwistsACantilever) {
  constexpr double kLength = 0.8, kEI = 5e4, kGJ = 2e4, kMoment = 0.3;
  Arm arm;
  arm.rows.resize(2);
  arm.rows[0].placement = DenavitHartenberg<double>{};
  arm.rows[1].placement = DenavitHartenberg<double>{0, kLength, 0, 0};
  arm.rows[0].beam = Beam<double>{.E = 1, .G = 1, .J = kGJ};
  arm.rows[0].beam->I.setConstant(kEI);
  Posture posture{Eigen::VectorXd()};
  posture.wrench = Wrench{Eigen::Vector3d::Zero(), kMoment * Eigen::Vector3d::UnitZ()};
  const auto bent = solveFlexibleKinematics(arm, posture, kTight);
  EXPECT_NEAR(bent.X_BD.p.y(), kMoment * kLength * kLength / (2 * kEI), 1e-12);
  EXPECT_NEAR(bent.X_BD.R(1, 0), kMoment * kLength / kEI, 1e-12);
  posture.wrench = Wrench{Eigen::Vector3d::Zero(), kMoment * Eigen::Vector3d::UnitX()};
  const auto twisted = solveFlexibleKinematics(arm, posture, kTight);
  EXPECT_NEAR(twisted.X_BD.R(2, 1), kMoment * kLength / kGJ, 1e-12);
  EXPECT_NEAR(twisted.rows[0].moment_L.x(), kMoment, 1e-12);
}

TEST(Wrench, RigidMomentsHaveIt) {
  std::mt19937_64 random(34);
  for (const Arm& bare : effectArms()) {
    const Arm arm = rigidCopy(bare);
    Posture posture = randomPosture(arm, random);
    posture.wrench = randomWrench(random, 100, 50);
    const auto moments = rigidMoments<double>(arm, posture);
    const auto shape = solveFlexibleKinematics(arm, posture);
    for (std::size_t k = 0; k < moments.size(); ++k)
      EXPECT_LE((moments[k] - shape.rows[k].moment_L).norm(), 1e-9 * (1 + moments[k].norm())) << arm.name << k;
  }
}

TEST(Wrench, DerivativesAreDifferences) {
  std::mt19937_64 random(32);
  for (const Arm& bare : effectArms()) {
    for (const bool with_effects : {false, true}) {
      Arm arm = bare;
      if (with_effects)
        for (const Effect& effect : allEffects(bare)) {
          // Gaps and knees have no derivative at their transitions: see effects_derivatives_test.cpp.
          if (effectKinds()[effect.kind].stage == EffectStage::kFlexibility) continue;
          arm.effects.push_back(sized(bare, effect, 0.02));
        }
      std::vector<Variable> variables = jointVariables(arm);
      variables.push_back(Variable::load());
      for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
      for (int axis = 0; axis < 3; ++axis)
        variables.push_back(Variable::number(findParameter(arm, std::string("tool.tip.") + "xyz"[axis])->path));
      for (int n = 0; n < 3; ++n) {
        Posture posture = randomPosture(arm, random);
        posture.wrench = randomWrench(random, 100, 50);
        const auto exact = differentiateTip(arm, posture, variables, kTight);
        ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged) << arm.name;
        for (std::size_t k = 0; k < variables.size(); ++k) {
          const auto column = static_cast<Eigen::Index>(k);
          const double h = variables[k].type == Variable::Type::kLoad ? 5 : 1e-3;
          const Difference d = centralDifference(arm, posture, variables[k], h);
          const double off =
              (d.position - exact.position_B.col(column)).norm() + (d.rotation - exact.rotation_B.col(column)).norm();
          EXPECT_LE(off, 1e-6 * (d.position.norm() + d.rotation.norm()) + 1e-12 / h) << arm.name << " " << k;
        }
      }
    }
  }
}

TEST(Wrench, LeavesNothingBehind) {
  std::mt19937_64 random(33);
  for (const Arm& arm : effectArms()) {
    PreparedArm prepared(arm);
    TipDifferentiation tips(arm);
    const auto joints = jointVariables(arm);
    for (int n = 0; n < 12; ++n) {
      Posture posture = randomPosture(arm, random);
      if (n % 3 == 1) posture.wrench = randomWrench(random, 100, 50);
      if (n % 6 == 4) posture.wrench = Wrench{};
      ASSERT_EQ(prepared.solve(posture), KinematicsStatus::kConverged);
      ASSERT_EQ(tips.solve(posture, joints), KinematicsStatus::kConverged);
      PreparedArm alone(arm);
      ASSERT_EQ(alone.solve(posture), KinematicsStatus::kConverged);
      EXPECT_EQ(prepared.X_BD().p, alone.X_BD().p) << arm.name << " " << n;
      EXPECT_EQ(prepared.shape().rows.front().moment_B, alone.shape().rows.front().moment_B) << arm.name << " " << n;
      const auto derivatives = differentiateTip(arm, posture, joints);
      EXPECT_LE((tips.columns().topRows<3>() - derivatives.position_B).norm(), 1e-12) << arm.name << " " << n;
    }
  }
}

}  // namespace
}  // namespace tubeplan::deflection
