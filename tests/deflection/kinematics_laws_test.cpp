// Laws that the flexible shape must obey at every posture.
#include <gtest/gtest.h>

#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

TEST(KinematicsLaws, ARigidArmDoesNotMove) {
  std::mt19937_64 random(1);
  const Arm arm = rigidCopy(cobraArm());
  for (int n = 0; n < 20; ++n) {
    const auto shape = solveFlexibleKinematics(arm, {randomJoints(arm, random), 100});
    EXPECT_LE((shape.X_BD.p - shape.X_BT.p).norm(), 1e-14);
    EXPECT_TRUE(shape.components.empty());
  }
}

TEST(KinematicsLaws, AWeightlessArmDoesNotMove) {
  Arm arm = cobraArm();
  for (auto& row : arm.rows) row.weight = {};
  std::mt19937_64 random(2);
  const auto shape = solveFlexibleKinematics(arm, {randomJoints(arm, random), 0});
  EXPECT_LE((shape.X_BD.p - shape.X_BT.p).norm(), 1e-14);
}

TEST(KinematicsLaws, TurningBaseAndGravityTogetherChangesNothing) {
  std::mt19937_64 random(3);
  const Arm arm = cobraArm();
  for (int n = 0; n < 20; ++n) {
    const Eigen::Vector3d down_W = randomDirection(random);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(2.1, randomDirection(random)).toRotationMatrix();
    Arm turned = arm, still = arm;
    still.gravity_W = down_W;
    turned.gravity_W = R * down_W;
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity(), X_WB_turned = Eigen::Isometry3d::Identity();
    X_WB_turned.linear() = R;
    const auto q = randomJoints(arm, random);
    const auto a = solveFlexibleKinematics(still, {q, 50, gravityInBase(still, X_WB)}, {1e-14, 100});
    const auto b = solveFlexibleKinematics(turned, {q, 50, gravityInBase(turned, X_WB_turned)}, {1e-14, 100});
    EXPECT_LE((R * (X_WB * a.X_BD.p) - X_WB_turned * b.X_BD.p).norm(), 1e-12);
  }
}

TEST(KinematicsLaws, TheBaseCarriesTheWholeWeight) {
  const Arm arm = cobraArm();
  double weight = 40;
  for (int i = 0; i < static_cast<int>(arm.rows.size()); ++i) {
    const double length = i + 1 < static_cast<int>(arm.rows.size())
                              ? std::get<DenavitHartenberg<double>>(arm.rows[i + 1].placement).a
                              : arm.p_LT.norm();
    weight += arm.rows[i].weight.distributed * length + arm.rows[i].weight.end;
  }
  std::mt19937_64 random(4);
  for (int n = 0; n < 20; ++n) {
    const auto shape = solveFlexibleKinematics(arm, {randomJoints(arm, random), 40});
    EXPECT_NEAR(shape.rows[0].force_B.z(), -weight, 1e-9 * weight);
    EXPECT_LE((shape.rows[0].X_BL.R * shape.rows[0].force_L - shape.rows[0].force_B).norm(), 1e-9);
  }
}

TEST(KinematicsLaws, MomentsAreTakenOnTheDeflectedShape) {
  Arm arm = cobraArm();
  for (auto& row : arm.rows) row.weight = {};
  std::mt19937_64 random(5);
  for (int n = 0; n < 20; ++n) {
    const auto shape = solveFlexibleKinematics(arm, {randomJoints(arm, random), 150}, {1e-14, 100});
    for (const auto& row : shape.rows) {
      const Eigen::Vector3d expected = (shape.X_BD.p - row.X_BL.p).cross(Eigen::Vector3d(0, 0, -150));
      EXPECT_LE((row.moment_B - expected).norm(), 1e-8);
    }
  }
}

TEST(KinematicsLaws, TheCobraSettlesWithinTenPasses) {
  std::mt19937_64 random(6);
  const Arm arm = cobraArm();
  for (int n = 0; n < 200; ++n) {
    const auto shape = solveFlexibleKinematics(arm, {randomJoints(arm, random), 40 * kPound});
    ASSERT_EQ(shape.status, KinematicsStatus::kConverged);
    EXPECT_LE(shape.iterations, 10);
  }
}

// Fixed angles must reproduce their rotation even if roll and yaw rotate about the same line, exactly or up to
// rounding.
TEST(FixedAngles, MakeTheirRotationAgain) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> angle(-3, 3), tiny(-1e-15, 1e-15);
  for (int k = 0; k < 1000; ++k) {
    const double pitch = k % 2 ? angle(random) / 2 : (k % 4 ? 1 : -1) * std::numbers::pi / 2 + (k % 3) * tiny(random);
    const Eigen::Vector3d rpy(angle(random), pitch, angle(random));
    const Eigen::Matrix3d R = rotationFromFixedAngles<double>(rpy);
    EXPECT_LE((rotationFromFixedAngles<double>(fixedAnglesOf(R)) - R).norm(), 1e-14) << rpy.transpose();
  }
}

}  // namespace
}  // namespace tubeplan::deflection
