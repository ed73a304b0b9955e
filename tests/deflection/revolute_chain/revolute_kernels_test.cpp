// Kernels must compute the shapes of the general sweeps, bit-identical for every number of lanes.
#include <gtest/gtest.h>

#include "deflection/revolute_chain/kernels.hpp"
#include "deflection/revolute_chain/revolute_chain.hpp"
#include "tests/deflection/revolute_chain/revolute_arms.hpp"

namespace {
#define TUBEPLAN_LANES 1
#include "deflection/revolute_chain/lanes.hpp"
#undef TUBEPLAN_LANES
}  // namespace

namespace tubeplan::deflection {
namespace {

TEST(SineCosine, AreTheLibrarysToTheLastPlaces) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-12, 4.9);
  const double eps = std::numeric_limits<double>::epsilon();
  for (int n = 0; n < 200000; ++n) {
    const double x = (n % 2 ? 1 : -1) * std::pow(10., exponent(random));
    const auto both = sineCosine(x);
    ASSERT_LE(std::abs(both.sine - std::sin(x)), eps * std::abs(std::sin(x))) << x;
    ASSERT_LE(std::abs(both.cosine - std::cos(x)), eps * std::abs(std::cos(x))) << x;
  }
  for (int quarter = -50; quarter <= 50; ++quarter)
    for (const double off : {0., 1e-9, -1e-5}) {
      const double x = quarter * std::numbers::pi / 2 + off;
      ASSERT_LE(std::abs(sineCosine(x).sine - std::sin(x)), eps * std::abs(std::sin(x))) << x;
      ASSERT_LE(std::abs(sineCosine(x).cosine - std::cos(x)), eps * std::abs(std::cos(x))) << x;
    }
  EXPECT_EQ(sineCosine(1e9).sine, std::sin(1e9));
  EXPECT_TRUE(std::isnan(sineCosine(std::numeric_limits<double>::quiet_NaN()).sine));
  EXPECT_TRUE(std::isnan(sineCosine(std::numeric_limits<double>::infinity()).cosine));
  for (double x = -0.0999; x < 0.1; x += 1e-4) {
    const auto both = smallSineCosine(x);
    ASSERT_NEAR(both.sine, std::sin(x), 2e-17 + eps * std::abs(x));
    ASSERT_NEAR(both.cosine, std::cos(x), eps);
    double c = std::cos(1.), s = std::sin(1.);
    rotateBySmallAngle(x / 100, c, s);
    ASSERT_NEAR(c, std::cos(1 + x / 100), 4e-16);
    ASSERT_NEAR(s, std::sin(1 + x / 100), 4e-16);
  }
}

TEST(Kernels, AreUsedForArmsThatTurnAboutOneAxisEverywhere) {
  for (const Arm& arm : kernelArms()) {
    EXPECT_NE(PreparedArm(arm).revoluteChain(), nullptr) << arm.name;
    EXPECT_TRUE(PreparedArm(arm).hasJacobian()) << arm.name;
  }
  EXPECT_EQ(PreparedArm(sixAxisArm()).revoluteChain(), nullptr);
  EXPECT_EQ(PreparedArm(mastArm()).revoluteChain(), nullptr);
  EXPECT_EQ(PreparedArm(withoutKernel(cobraArm())).revoluteChain(), nullptr);
}

TEST(Kernels, HaveTheShapeOfTheGeneralSweeps) {
  std::mt19937_64 random(2);
  for (const Arm& arm : kernelArms()) {
    const Arm general = withoutKernel(arm);
    PreparedArm fast(arm), slow(general);
    for (int n = 0; n < 100; ++n) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(fast.solve(posture, {1e-13, 100}), KinematicsStatus::kConverged) << arm.name;
      ASSERT_EQ(slow.solve(posture, {1e-14, 100}), KinematicsStatus::kConverged) << arm.name;
      EXPECT_LE((fast.X_BD().p - slow.X_BD().p).norm(), 1e-12) << arm.name;
      EXPECT_LE((fast.X_BD().R - slow.X_BD().R).norm(), 1e-12) << arm.name;
      const auto a = fast.shape(), b = slow.shape();
      for (std::size_t i = 0; i < a.rows.size(); ++i) {
        EXPECT_LE((a.rows[i].X_BL.p - b.rows[i].X_BL.p).norm(), 1e-12) << arm.name << " row " << i;
        EXPECT_LE((a.rows[i].moment_L - b.rows[i].moment_L).norm(), 1e-9) << arm.name << " row " << i;
      }
      for (std::size_t e = 0; e < a.components.size(); ++e) {
        EXPECT_LE((a.components[e].rotation - b.components[e].rotation).norm(), 1e-12) << arm.name << " " << e;
        EXPECT_LE((a.components[e].displacement - b.components[e].displacement).norm(), 1e-12) << arm.name << " " << e;
      }
      EXPECT_LE((a.X_BD.p - fast.X_BD().p).norm(), 1e-14);
    }
  }
}

/// With the default tolerance, the tip must be within that tolerance of its position at equilibrium.
TEST(Kernels, StopWithinTheTolerance) {
  std::mt19937_64 random(3);
  for (const Arm& arm : kernelArms()) {
    PreparedArm prepared(arm);
    for (int n = 0; n < 200; ++n) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(prepared.solve(posture), KinematicsStatus::kConverged);
      const Eigen::Vector3d found = prepared.X_BD().p;
      ASSERT_EQ(prepared.solve(posture, {1e-15, 100}), KinematicsStatus::kConverged);
      EXPECT_LE((found - prepared.X_BD().p).norm(), FlexibleKinematicsOptions{}.tolerance * reachOf(arm)) << arm.name;
    }
  }
}

TEST(Kernels, GiveTheSameBitsInAnyNumberOfLanes) {
  std::mt19937_64 random(4);
  for (const Arm& arm : kernelArms()) {
    const PreparedArm prepared(arm);
    const simd::RevoluteArm numbers = prepared.revoluteChain()->numbers();
    const PostureBatch batch = randomBatch(arm, 8, random);
    const int columns = numbers.joints + simd::kGravityTurns + 2 * numbers.count;
    Side poses(12, 8), one_poses(12, 8), jacobian = Side::Zero(6 * columns, 8), one_jacobian = jacobian;
    double sweeps[8], one_sweeps[8];
    const auto run = [&](const simd::Kernel& kernel, Side& pose, Side& derivative, double* took) {
      for (int k = 0; k < 8; k += kernel.lanes)
        kernel.solve(
            numbers,
            {batch.q.data() + k, batch.load.data() + k, batch.gravity_B.data() + k, 8, 1e-10 * numbers.reach, 100},
            {pose.data() + k, derivative.data() + k, took + k, nullptr, 8, 8,
             derivative.row(6 * numbers.joints).data() + k,
             derivative.row(6 * (numbers.joints + simd::kGravityTurns)).data() + k});
    };
    run(simd::kernels().front(), one_poses, one_jacobian, one_sweeps);
    for (const simd::Kernel& kernel : simd::kernels()) {
      run(kernel, poses, jacobian, sweeps);
      EXPECT_EQ(poses, one_poses) << arm.name << " in " << kernel.lanes;
      EXPECT_EQ(jacobian, one_jacobian) << arm.name << " in " << kernel.lanes;
      for (int k = 0; k < 8; ++k) EXPECT_EQ(sweeps[k], one_sweeps[k]) << arm.name << " in " << kernel.lanes;
    }
  }
}

TEST(Kernels, TellTheFrameOfEveryRow) {
  std::mt19937_64 random(8);
  for (const Arm& arm : kernelArms()) {
    PreparedArm prepared(arm);
    const simd::RevoluteChain& chain = *prepared.revoluteChain();
    const simd::RevoluteArm numbers = chain.numbers();
    ASSERT_EQ(chain.rows().size(), arm.rows.size()) << arm.name;
    std::vector<double> turns(12 * static_cast<std::size_t>(numbers.count));
    double pose[12], sweeps = 0;
    simd::Shapes shapes{};
    shapes.pose = pose;
    shapes.sweeps = &sweeps;
    shapes.turns = turns.data();
    shapes.stride = 1;
    for (int trial = 0; trial < 50; ++trial) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(prepared.solve(posture), KinematicsStatus::kConverged);
      simd::kernels().front().solve(
          numbers, {posture.q.data(), &posture.load, posture.gravity_B.data(), 1, 1e-10 * numbers.reach, 100}, shapes);
      for (const simd::RowOnTurn& row : chain.rows()) {
        PoseOf<double> X;
        if (row.turn >= 0) {
          const double* at = turns.data() + 12 * row.turn;
          X = {Eigen::Map<const Eigen::Matrix3d>(at + 3), Eigen::Map<const Eigen::Vector3d>(at)};
        }
        X = X * row.X_TL;
        const PoseOf<double> expected = prepared.X_BL(row.row);
        EXPECT_LE((X.p - expected.p).norm(), 1e-12) << arm.name << " row " << row.row;
        EXPECT_LE((X.R - expected.R).norm(), 1e-12) << arm.name << " row " << row.row;
      }
    }
  }
}

/// If the compliance of a row merges with the previous row into one turn, the chain must not report row frames.
TEST(Kernels, ARowWithinATurnIsNotToldOf) {
  Arm arm = cobraArm();
  Row<double> hinge = arm.rows[4];
  hinge.name = "hinge";
  hinge.placement = DenavitHartenberg<double>{};
  hinge.joint = {};
  hinge.weight = {};
  hinge.beam.reset();
  arm.rows.insert(arm.rows.begin() + 4, hinge);
  arm.rows[4].placement = arm.rows[5].placement;
  arm.rows[5].placement = DenavitHartenberg<double>{};
  const PreparedArm prepared(arm);
  ASSERT_NE(prepared.revoluteChain(), nullptr);
  EXPECT_TRUE(prepared.revoluteChain()->rows().empty());
}

}  // namespace
}  // namespace tubeplan::deflection
