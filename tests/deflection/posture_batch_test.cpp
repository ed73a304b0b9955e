// Kernels and batches: the same shapes whatever solves them, one posture or many, and what fails told alone.
#include "deflection/posture_batch.hpp"

#include <gtest/gtest.h>

#include "deflection/hinges/hinge_chain.hpp"
#include "deflection/hinges/kernels.hpp"
#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effect_arms.hpp"

namespace {
#define TUBEPLAN_LANES 1
#include "deflection/hinges/lanes.hpp"
#undef TUBEPLAN_LANES
}  // namespace

namespace tubeplan::deflection {
namespace {

/// An arm for the kernels with all that they know: beams in several pieces, one that twists, lumps, a leaning tool, a
/// spring across a joint's axis, a beam that starts off its turn.
Arm oddHingeArm() {
  Arm arm = cobraArm(3);
  arm.name = "odd";
  arm.rows[2].joint_stiffness[1] = 3e5;
  arm.rows[3].weight.lumps = {{70, {0.3, 0.05, 0.1}}};
  arm.rows[4].beam = Beam<double>{7e10, {kRigid, 3e-7, kRigid}, kRigid, kRigid, 2};
  arm.rows[4].weight.lumps = {{30, {0, 0.1, 0.05}}};
  arm.rows[5].beam = Beam<double>{kRigid, Eigen::Vector3d::Constant(kRigid), 2.6e10, 4e-8, 1};
  arm.rows[5].placement = Origin<double>{{0.49, 0.02, 0.03}, {0.2, -0.3, 0.1}};
  arm.rows[5].joint.offset = 0.05;
  return arm;
}

std::vector<Arm> kernelArms() { return {cobraArm(), cobraArm(4), rigidCopy(cobraArm()), oddHingeArm()}; }

/// The arm solved by the general sweeps: a force at the tip, too small to move it, keeps the kernels off.
Arm withoutKernel(const Arm& arm) { return withEffect(arm, "contact-force", "tip", {1e-200}); }

Posture randomCase(const Arm& arm, std::mt19937_64& random) {
  std::uniform_real_distribution<double> load(0, 300);
  return {randomJoints(arm, random), load(random), randomDirection(random)};
}

PostureBatch randomBatch(const Arm& arm, Eigen::Index count, std::mt19937_64& random) {
  PostureBatch batch;
  batch.resize(static_cast<Eigen::Index>(activeRows(arm).size()), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Posture posture = randomCase(arm, random);
    batch.q.col(k) = posture.q;
    batch.load[k] = posture.load;
    batch.gravity_B.col(k) = posture.gravity_B;
  }
  return batch;
}

Posture postureOf(const PostureBatch& batch, Eigen::Index k) {
  return {batch.q.col(k), batch.load[k], batch.gravity_B.col(k)};
}

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
    turnLittle(x / 100, c, s);
    ASSERT_NEAR(c, std::cos(1 + x / 100), 4e-16);
    ASSERT_NEAR(s, std::sin(1 + x / 100), 4e-16);
  }
}

TEST(Kernels, AreUsedForArmsThatTurnAboutOneAxisEverywhere) {
  for (const Arm& arm : kernelArms()) {
    EXPECT_NE(PreparedArm(arm).hinges(), nullptr) << arm.name;
    EXPECT_TRUE(PreparedArm(arm).hasJacobian()) << arm.name;
  }
  EXPECT_EQ(PreparedArm(sixAxisArm()).hinges(), nullptr);
  EXPECT_EQ(PreparedArm(mastArm()).hinges(), nullptr);
  EXPECT_EQ(PreparedArm(withoutKernel(cobraArm())).hinges(), nullptr);
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

/// At the usual tolerance the tip is as near to rest as the tolerance says.
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
    const hinges::HingeArm numbers = prepared.hinges()->numbers();
    const PostureBatch batch = randomBatch(arm, 8, random);
    const int columns = numbers.joints + hinges::kGravityTurns + 2 * numbers.count;
    Side poses(12, 8), one_poses(12, 8), jacobian = Side::Zero(6 * columns, 8), one_jacobian = jacobian;
    double sweeps[8], one_sweeps[8];
    const auto run = [&](const hinges::Kernel& kernel, Side& pose, Side& derivative, double* took) {
      for (int k = 0; k < 8; k += kernel.lanes)
        kernel.solve(
            numbers,
            {batch.q.data() + k, batch.load.data() + k, batch.gravity_B.data() + k, 8, 1e-10 * numbers.reach, 100},
            {pose.data() + k, derivative.data() + k, took + k, nullptr, 8, 8,
             derivative.row(6 * numbers.joints).data() + k,
             derivative.row(6 * (numbers.joints + hinges::kGravityTurns)).data() + k});
    };
    run(hinges::kernels().front(), one_poses, one_jacobian, one_sweeps);
    for (const hinges::Kernel& kernel : hinges::kernels()) {
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
    const hinges::HingeChain& chain = *prepared.hinges();
    const hinges::HingeArm numbers = chain.numbers();
    ASSERT_EQ(chain.rows().size(), arm.rows.size()) << arm.name;
    std::vector<double> turns(12 * static_cast<std::size_t>(numbers.count));
    double pose[12], sweeps = 0;
    hinges::Shapes shapes{};
    shapes.pose = pose;
    shapes.sweeps = &sweeps;
    shapes.turns = turns.data();
    shapes.stride = 1;
    for (int trial = 0; trial < 50; ++trial) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(prepared.solve(posture), KinematicsStatus::kConverged);
      hinges::kernels().front().solve(
          numbers, {posture.q.data(), &posture.load, posture.gravity_B.data(), 1, 1e-10 * numbers.reach, 100}, shapes);
      for (const hinges::RowOnTurn& row : chain.rows()) {
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

/// What turns after a row's frame, about the same axis at the same place, makes one turn with what is before it.
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
  ASSERT_NE(prepared.hinges(), nullptr);
  EXPECT_TRUE(prepared.hinges()->rows().empty());
}

TEST(PostureBatch, IsEachPostureAlone) {
  std::mt19937_64 random(5);
  std::vector<Arm> arms = kernelArms();
  for (const Arm& arm : effectArms()) {
    arms.push_back(arm);
    arms.push_back(arm);
    for (const Effect& effect : allEffects(arm)) arms.back().effects.push_back(sized(arm, effect, 0.02));
  }
  for (const Arm& arm : arms) {
    BatchKinematics kinematics(arm);
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
    BatchKinematics kinematics(arm);
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

/// All that a kernel has derivatives by: joints, gravity's turns, stiffnesses.
std::vector<Variable> kernelVariables(const Arm& arm) {
  std::vector<Variable> variables = jointVariables(arm);
  for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
  for (const auto& p : parametersOf(arm))
    if (p.quantity == Quantity::kTorquePerAngle || p.quantity == Quantity::kPressure ||
        p.quantity == Quantity::kLengthToTheFourth)
      variables.push_back(Variable::number(p.path));
  return variables;
}

/// A variable's step, and what makes its columns comparable.
double sizeOf(const Arm& arm, const Variable& variable) {
  Arm copy = arm;
  return variable.type == Variable::Type::kParameter ? locate(copy, variable.parameter) : 1;
}

TEST(PostureBatch, DerivativesByStiffnessesAndGravityAreThoseOfTheGeneralSensitivities) {
  std::mt19937_64 random(9);
  for (const Arm& arm : kernelArms()) {
    const Arm general = withoutKernel(arm);
    const auto variables = kernelVariables(arm);
    BatchKinematics kinematics(arm);
    ASSERT_TRUE(kinematics.hasKernel(variables)) << arm.name;
    TipDifferentiation alone(arm), slow(general);
    TipBatch tips;
    const PostureBatch batch = randomBatch(arm, 27, random);
    kinematics.solveWithDerivatives(batch, variables, tips, {1e-14, 100});
    ASSERT_EQ(tips.jacobian.rows(), 6 * std::ssize(variables));
    for (Eigen::Index k = 0; k < batch.size(); ++k) {
      ASSERT_EQ(alone.solve(postureOf(batch, k), variables, {1e-14, 100}), KinematicsStatus::kConverged);
      EXPECT_EQ(Eigen::VectorXd(tips.jacobian.col(k)), Eigen::VectorXd(alone.columns().reshaped())) << arm.name;
      EXPECT_EQ(tips.X_BD(k).p, alone.arm().X_BD().p);
      ASSERT_EQ(slow.solve(postureOf(batch, k), variables, {1e-14, 100}), KinematicsStatus::kConverged);
      for (std::size_t v = 0; v < variables.size(); ++v) {
        const auto column = static_cast<Eigen::Index>(v);
        const double off = (alone.columns().col(column) - slow.columns().col(column)).norm();
        EXPECT_LE(off * sizeOf(arm, variables[v]), 1e-11) << arm.name << " variable " << v;
      }
    }
  }
}

TEST(PostureBatch, DerivativesByStiffnessesAndGravityAreDifferencesOfShapes) {
  std::mt19937_64 random(10);
  for (const Arm& arm : kernelArms()) {
    const auto variables = kernelVariables(arm);
    TipDifferentiation tip(arm);
    for (int n = 0; n < 8; ++n) {
      const Posture posture = randomCase(arm, random);
      ASSERT_EQ(tip.solve(posture, variables, kTight), KinematicsStatus::kConverged);
      for (std::size_t v = 0; v < variables.size(); ++v) {
        const double h = 1e-3 * sizeOf(arm, variables[v]);
        const Difference d = centralDifference(arm, posture, variables[v], h);
        const auto column = tip.columns().col(static_cast<Eigen::Index>(v));
        EXPECT_LE((column.head<3>() - d.position).norm() * h, 1e-6 * d.position.norm() * h + 2e-13)
            << arm.name << " variable " << v;
        EXPECT_LE((column.tail<3>() - d.rotation).norm() * h, 1e-6 * d.rotation.norm() * h + 2e-13)
            << arm.name << " variable " << v;
      }
    }
  }
}

/// Two stiffnesses that bend about the same axis share it by their parts.
TEST(PostureBatch, StiffnessesOfOneAxisAreToldApart) {
  Arm arm = cobraArm();
  arm.rows[3].beam->I = {3e-7, 5e-7, kRigid};
  arm.rows[4].placement = Origin<double>{{0.4, 0.4, 0}, {0, 0, 0}};  // the member between the two axes
  const std::vector<Variable> variables{Variable::number(findParameter(arm, "latch-link.beam.Ix")->path),
                                        Variable::number(findParameter(arm, "latch-link.beam.Iy")->path),
                                        Variable::number(findParameter(arm, "latch-link.beam.E")->path)};
  const Posture posture{Eigen::Vector4d(0.3, 0.8, -0.5, 0.2), 100, Eigen::Vector3d(0.1, -0.3, -1).normalized()};
  ASSERT_TRUE(BatchKinematics(arm).hasKernel(variables));
  TipDifferentiation tip(arm);
  ASSERT_EQ(tip.solve(posture, variables, kTight), KinematicsStatus::kConverged);
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const Difference d = centralDifference(arm, posture, variables[v], 1e-3 * sizeOf(arm, variables[v]));
    EXPECT_LE((tip.columns().col(static_cast<Eigen::Index>(v)).head<3>() - d.position).norm(),
              1e-6 * d.position.norm());
    EXPECT_GT(d.position.norm(), 0);
  }
}

TEST(PostureBatch, OtherVariablesAndArmsAreDerivedOneByOne) {
  const Arm arm = cobraArm();
  const std::vector<Variable> variables{Variable::number(findParameter(arm, "forearm.dh.a")->path), Variable::load()};
  std::mt19937_64 random(11);
  BatchKinematics kinematics(arm);
  EXPECT_FALSE(kinematics.hasKernel(variables));
  EXPECT_TRUE(kinematics.hasKernel({}));
  EXPECT_FALSE(BatchKinematics(withoutKernel(arm)).hasKernel({}));
  TipBatch tips;
  TipDifferentiation alone(arm);
  const PostureBatch batch = randomBatch(arm, 5, random);
  kinematics.solveWithDerivatives(batch, variables, tips);
  for (Eigen::Index k = 0; k < batch.size(); ++k) {
    alone.solve(postureOf(batch, k), variables);
    EXPECT_EQ(Eigen::VectorXd(tips.jacobian.col(k)), Eigen::VectorXd(alone.columns().reshaped()));
  }
}

TEST(PostureBatch, TellsWhatFailsAloneAndLeavesTheOthersAsTheyAre) {
  std::mt19937_64 random(8);
  Arm soft = cobraArm();
  soft.rows[5].joint_stiffness[2] /= 200;
  for (const Arm& arm : {cobraArm(), soft, rigidCopy(cobraArm()), withoutKernel(cobraArm())}) {
    BatchKinematics kinematics(arm);
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
      if (k == 20 && !arm.rows[0].beam) continue;  // nothing in a rigid arm asks for the load
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
  BatchKinematics kinematics(arm);
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
