// Each posture of a batch must be solved as if it were alone, and a failure must be reported for its own posture only.
#include "deflection/kinematics.hpp"

#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/revolute_chain/revolute_arms.hpp"

namespace tubeplan::deflection {
namespace {

TEST(PostureBatch, IsEachPostureAlone) {
  std::mt19937_64 random(5);
  std::vector<Arm> arms = kernelArms();
  for (const Arm& arm : effectArms()) {
    arms.push_back(arm);
    arms.push_back(arm);
    for (const Effect& effect : allEffects(arm)) arms.back().effects.push_back(sized(arm, effect, 0.02));
  }
  for (const Arm& arm : arms) {
    Kinematics kinematics(arm);
    PreparedArm alone(arm);
    TipDifferentiation derivative(arm);
    TipBatch tips;
    for (const Eigen::Index count : {1, 2, 3, 7, 8, 9, 17}) {
      const PostureBatch batch = randomBatch(arm, count, random);
      kinematics.solveWithJacobian(batch, tips);
      for (Eigen::Index k = 0; k < count; ++k) {
        ASSERT_EQ(tips.status[static_cast<std::size_t>(k)], alone.solve(postureOf(batch, k))) << arm.name;
        if (alone.status() != KinematicsStatus::kConverged) continue;
        EXPECT_EQ(tips.X_BD(k).p, alone.X_BD().p) << arm.name << " " << k << " of " << count;
        EXPECT_EQ(tips.X_BD(k).R, alone.X_BD().R) << arm.name << " " << k << " of " << count;
        derivative.solve(postureOf(batch, k), jointVariables(arm));
        EXPECT_EQ(Eigen::VectorXd(tips.jacobian.col(k)), Eigen::VectorXd(derivative.columns().reshaped())) << arm.name;
      }
    }
    kinematics.solve(randomBatch(arm, 0, random), tips);
    EXPECT_TRUE(tips.status.empty());
  }
}

TEST(PostureBatch, JacobianIsTheDifferenceOfShapes) {
  std::mt19937_64 random(6);
  for (const Arm& arm : kernelArms()) {
    Kinematics kinematics(arm);
    TipBatch tips, before, after;
    const double step = 1e-5;
    for (int n = 0; n < 10; ++n) {
      const PostureBatch batch = randomBatch(arm, 11, random);
      kinematics.solveWithJacobian(batch, tips, {1e-14, 100});
      for (int j = 0; j < batch.q.rows(); ++j) {
        PostureBatch moved = batch;
        moved.q.row(j).array() += step;
        kinematics.solve(moved, after, {1e-15, 100});
        moved.q.row(j).array() -= 2 * step;
        kinematics.solve(moved, before, {1e-15, 100});
        for (Eigen::Index k = 0; k < batch.size(); ++k) {
          const Eigen::Vector3d p = (after.X_BD(k).p - before.X_BD(k).p) / (2 * step);
          EXPECT_LE((tips.jacobian.col(k).segment<3>(6 * j) - p).norm(), 2e-9) << arm.name << " joint " << j;
          const Eigen::Matrix3d spin = (after.X_BD(k).R - before.X_BD(k).R) / (2 * step) * tips.X_BD(k).R.transpose();
          const Eigen::Vector3d w(spin(2, 1), spin(0, 2), spin(1, 0));
          EXPECT_LE((tips.jacobian.col(k).segment<3>(6 * j + 3) - w).norm(), 2e-9) << arm.name << " joint " << j;
        }
      }
    }
  }
}

TEST(PostureBatch, JacobianIsThatOfTheGeneralSensitivities) {
  std::mt19937_64 random(7);
  for (const Arm& arm : kernelArms()) {
    const Arm general = withoutKernel(arm);
    TipDifferentiation fast(arm), slow(general);
    for (int n = 0; n < 50; ++n) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(fast.solve(posture, jointVariables(arm), {1e-14, 100}), KinematicsStatus::kConverged);
      ASSERT_EQ(slow.solve(posture, jointVariables(arm), {1e-14, 100}), KinematicsStatus::kConverged);
      EXPECT_LE((fast.columns() - slow.columns()).cwiseAbs().maxCoeff(), 1e-11) << arm.name;
    }
  }
}

TEST(PostureBatch, TellsWhatFailsAloneAndLeavesTheOthersAsTheyAre) {
  std::mt19937_64 random(8);
  Arm soft = cobraArm();
  soft.rows[5].joint_stiffness[2] /= 200;
  for (const Arm& arm : {cobraArm(), soft, rigidCopy(cobraArm()), withoutKernel(cobraArm())}) {
    Kinematics kinematics(arm);
    const PostureBatch good = randomBatch(cobraArm(), 21, random);
    PostureBatch mixed = good;
    mixed.q(2, 4) = std::numeric_limits<double>::quiet_NaN();
    mixed.q(0, 13) = std::numeric_limits<double>::infinity();
    mixed.load[20] = std::numeric_limits<double>::quiet_NaN();
    TipBatch expected, found;
    kinematics.solveWithJacobian(good, expected);
    kinematics.solveWithJacobian(mixed, found);
    for (Eigen::Index k = 0; k < good.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (k == 20 && !arm.rows[0].beam) continue;  // a rigid arm does not depend on the load
      if (k == 4 || k == 13 || k == 20) {
        EXPECT_NE(found.status[i], KinematicsStatus::kConverged) << k;
        EXPECT_TRUE(found.poses.col(k).array().isNaN().all()) << k;
        EXPECT_TRUE(found.jacobian.col(k).array().isNaN().all()) << k;
        continue;
      }
      ASSERT_EQ(found.status[i], expected.status[i]) << k;
      if (expected.status[i] != KinematicsStatus::kConverged) continue;
      EXPECT_EQ(Eigen::VectorXd(found.poses.col(k)), Eigen::VectorXd(expected.poses.col(k))) << k;
      EXPECT_EQ(Eigen::VectorXd(found.jacobian.col(k)), Eigen::VectorXd(expected.jacobian.col(k))) << k;
    }
  }
}

TEST(PostureBatch, AShapeThatDoesNotSettleIsTold) {
  Arm arm = cobraArm();
  for (auto& row : arm.rows) row.joint_stiffness /= 3000;
  Kinematics kinematics(arm);
  PostureBatch batch;
  batch.resize(4, 9, 500);
  batch.q.setConstant(0.5);
  batch.load[3] = 0;
  TipBatch tips;
  kinematics.solve(batch, tips, {1e-10, 5});
  PreparedArm alone(arm);
  for (Eigen::Index k = 0; k < batch.size(); ++k)
    EXPECT_EQ(tips.status[static_cast<std::size_t>(k)], alone.solve(postureOf(batch, k), {1e-10, 5})) << k;
  EXPECT_EQ(tips.status[0], KinematicsStatus::kNotConverged);
}

}  // namespace
}  // namespace tubeplan::deflection
