// A kernel's derivatives with respect to stiffnesses and the direction of gravity must agree with the general solver
// and with difference quotients.
#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/revolute_chain/revolute_arms.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns all variables for which a kernel has derivatives: joints, rotations of gravity, stiffnesses.
std::vector<Variable> kernelVariables(const Arm& arm) {
  std::vector<Variable> variables = jointVariables(arm);
  for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
  for (const auto& p : parametersOf(arm))
    if (p.quantity == Quantity::kTorquePerAngle || p.quantity == Quantity::kPressure ||
        p.quantity == Quantity::kLengthToTheFourth)
      variables.push_back(Variable::number(p.path));
  return variables;
}

/// Returns the scale of a variable, which sets its step and makes columns of derivatives comparable: its value, or 1.
double sizeOf(const Arm& arm, const Variable& variable) {
  Arm copy = arm;
  return variable.type == Variable::Type::kParameter ? locate(copy, variable.parameter) : 1;
}

TEST(PostureBatch, DerivativesByStiffnessesAndGravityAreThoseOfTheGeneralSensitivities) {
  std::mt19937_64 random(9);
  for (const Arm& arm : kernelArms()) {
    const Arm general = withoutKernel(arm);
    const auto variables = kernelVariables(arm);
    Kinematics kinematics(arm);
    ASSERT_NE(PreparedArm(arm).kernelFor(variables), nullptr) << arm.name;
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

/// If several stiffnesses determine the bending about one axis, the derivative with respect to each of them must agree
/// with a difference quotient.
TEST(PostureBatch, StiffnessesOfOneAxisAreToldApart) {
  Arm arm = cobraArm();
  arm.rows[3].beam->I = {3e-7, 5e-7, kRigid};
  arm.rows[4].placement = Origin<double>{{0.4, 0.4, 0}, {0, 0, 0}};  // the member lies between the x and y axes
  const std::vector<Variable> variables{Variable::number(findParameter(arm, "latch-link.beam.Ix")->path),
                                        Variable::number(findParameter(arm, "latch-link.beam.Iy")->path),
                                        Variable::number(findParameter(arm, "latch-link.beam.E")->path)};
  const Posture posture{Eigen::Vector4d(0.3, 0.8, -0.5, 0.2), 100, Eigen::Vector3d(0.1, -0.3, -1).normalized()};
  ASSERT_NE(PreparedArm(arm).kernelFor(variables), nullptr);
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
  Kinematics kinematics(arm);
  EXPECT_EQ(PreparedArm(arm).kernelFor(variables), nullptr);
  EXPECT_TRUE(PreparedArm(arm).hasJacobian());
  EXPECT_FALSE(PreparedArm(withoutKernel(arm)).hasJacobian());
  TipBatch tips;
  TipDifferentiation alone(arm);
  const PostureBatch batch = randomBatch(arm, 5, random);
  kinematics.solveWithDerivatives(batch, variables, tips);
  for (Eigen::Index k = 0; k < batch.size(); ++k) {
    alone.solve(postureOf(batch, k), variables);
    EXPECT_EQ(Eigen::VectorXd(tips.jacobian.col(k)), Eigen::VectorXd(alone.columns().reshaped()));
  }
}

}  // namespace
}  // namespace tubeplan::deflection
