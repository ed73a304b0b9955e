// On arms of any structure, the tip must be at the goal position, with the smallest tilt that the joints allow there.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <random>

#include "app/formats/arm/arm_reader.hpp"
#include "deflection/inverse/inverse_solver.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
const Vector3d kDown = -Vector3d::UnitZ();
constexpr double kToolLoad = 60;  // [N]

Arm shipped(const std::string& name) {
  return app::readArm(app::readYamlFile(TUBEPLAN_SOURCE_DIR "/app/cells/" + name).root).arm;
}

/// Posture well within the limits, neither stretched nor folded, and a goal: the posture's tip, with an axis tilted
/// relative to its tool axis.
struct TiltedGoal {
  VectorXd q;
  ToolGoal goal;
};

VectorXd drawnWithin(const Arm& arm, std::mt19937_64& random) {
  VectorXd q(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto& joint = arm.joint(k);
    const double share = std::uniform_real_distribution<>(0.2, 0.8)(random);
    q[k] = joint.lower + share * (joint.upper - joint.lower);
  }
  return q;
}

TiltedGoal tiltedGoalOf(const Arm& arm, double lean, std::mt19937_64& random) {
  for (;;) {
    TiltedGoal tilted{drawnWithin(arm, random), {}};
    const auto tip = differentiateTip(arm, {tilted.q, kToolLoad, kDown}, jointVariables(arm), {1e-14, 200});
    if (Eigen::JacobiSVD<Eigen::MatrixXd>(tip.position_B).singularValues().minCoeff() < 0.05 * reachOf(arm)) continue;
    const Vector3d axis = tip.kinematics.X_BD.R * arm.tool_axis_L;
    tilted.goal = {tip.kinematics.X_BD.p, Eigen::AngleAxisd(lean, axis.unitOrthogonal()) * axis};
    return tilted;
  }
}

double tiltOf(const Arm& arm, const TipDerivatives& tip, const ToolGoal& goal) {
  const Vector3d t = tip.kinematics.X_BD.R * arm.tool_axis_L;
  return std::atan2(t.cross(goal.axis_B).norm(), t.dot(goal.axis_B));
}

/// Returns the smallest tilt among nearby postures with the tip at the same position [rad].
double leastTiltNear(const Arm& arm, const ToolGoal& goal, const VectorXd& q, double step, std::mt19937_64& random) {
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 40; ++n) {
    auto tip = differentiateTip(arm, {q, kToolLoad, kDown}, jointVariables(arm), {1e-14, 200});
    VectorXd along(q.size());
    for (double& x : along) x = std::normal_distribution<>()(random);
    along -= tip.position_B.completeOrthogonalDecomposition().solve(tip.position_B * along);
    if (along.norm() < 1e-9) return tiltOf(arm, tip, goal);
    VectorXd near = q + step * along.normalized();
    for (int k = 0; k < 4; ++k) {
      tip = differentiateTip(arm, {near, kToolLoad, kDown}, jointVariables(arm), {1e-14, 200});
      near += tip.position_B.completeOrthogonalDecomposition().solve(goal.p_BT - tip.kinematics.X_BD.p);
    }
    least = std::min(least, tiltOf(arm, differentiateTip(arm, {near, kToolLoad, kDown}, jointVariables(arm)), goal));
  }
  return least;
}

class EachArm : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, EachArm,
                         ::testing::Values("tsm-cobra-arm.yaml", "column-arm.yaml", "puma-arm.yaml", "iiwa-arm.yaml"),
                         [](const auto& arm) {
                           std::string name = arm.param;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

TEST_P(EachArm, HoldsThePlaceWhateverTheAxisAsked) {
  const Arm arm = shipped(GetParam());
  std::mt19937_64 random(31);
  for (const double lean : {0., 0.001, 0.5, 3.}) {
    for (int n = 0; n < 6; ++n) {
      const TiltedGoal tilted = tiltedGoalOf(arm, lean * kDegree, random);
      const auto found = solveInverseKinematics(arm, tilted.goal, kToolLoad, kDown);
      ASSERT_EQ(found.status, BranchStatus::kConverged) << lean << " deg, " << n << ": " << found.reason;
      for (const Branch& branch : found.branches) {
        if (branch.status != BranchStatus::kConverged) continue;
        const auto shape = solveFlexibleKinematics(arm, {branch.q, kToolLoad, kDown}, {1e-14, 200});
        EXPECT_LE((shape.X_BD.p - tilted.goal.p_BT).norm(), 1e-9 * reachOf(arm));
      }
    }
  }
}

TEST_P(EachArm, TiltsTheLeastThatThePlaceAllows) {
  const Arm arm = shipped(GetParam());
  const InverseKinematicsOptions options;
  std::mt19937_64 random(32);
  constexpr double kStep = 1e-3;  // [rad]
  for (int n = 0; n < 4; ++n) {
    const TiltedGoal tilted = tiltedGoalOf(arm, 3 * kDegree, random);
    const auto found = solveInverseKinematics(arm, tilted.goal, kToolLoad, kDown);
    ASSERT_EQ(found.status, BranchStatus::kConverged) << found.reason;
    EXPECT_LE(found.branches.front().tilt, std::numbers::pi / 2);
    for (std::size_t k = 0; k < found.branches.size() && k < 4; ++k) {
      const Branch& branch = found.branches[k];
      if (branch.status != BranchStatus::kConverged) continue;
      // The solver may leave a tilt that the joints change by less than the singular floor per rad.
      EXPECT_LE(branch.tilt,
                leastTiltNear(arm, tilted.goal, branch.q, kStep, random) + 1.1 * options.singular_floor * kStep);
    }
  }
}

TEST_P(EachArm, FindsThePostureThatItWasAskedFromOrOneAsGood) {
  const Arm arm = shipped(GetParam());
  std::mt19937_64 random(33);
  for (int n = 0; n < 20; ++n) {
    const auto found = solveInverseKinematics(arm, tiltedGoalOf(arm, 0, random).goal, kToolLoad, kDown);
    ASSERT_EQ(found.status, BranchStatus::kConverged) << n << ": " << found.reason;
    double least = std::numeric_limits<double>::infinity();
    for (const Branch& branch : found.branches)
      if (branch.status == BranchStatus::kConverged) least = std::min(least, branch.tilt);
    EXPECT_LE(least, 1e-3) << n;
  }
}

TEST(LeastTilt, WhatIsFreeBringsJointsBackWithinTheirLimits) {
  Arm arm = shipped("iiwa-arm.yaml");
  std::mt19937_64 random(34);
  const TiltedGoal tilted = tiltedGoalOf(arm, 0, random);
  for (auto& row : arm.rows)
    if (row.joint.name == "A3") row.joint.lower = tilted.q[2] - 0.02, row.joint.upper = tilted.q[2] + 0.02;
  VectorXd start = tilted.q;
  start[2] += 0.3;
  const Branch branch = refineBranch(arm, tilted.goal, kToolLoad, kDown, start);
  EXPECT_EQ(branch.status, BranchStatus::kConverged) << branch.reason;
}

TEST(LeastTilt, ATiltThatIsTooLargeIsSaidToBe) {
  const Arm arm = shipped("column-arm.yaml");
  std::mt19937_64 random(35);
  InverseKinematicsOptions options;
  options.max_tilt = 2 * kDegree;
  const auto found =
      solveInverseKinematics(arm, tiltedGoalOf(arm, 3 * kDegree, random).goal, kToolLoad, kDown, options);
  EXPECT_EQ(found.status, BranchStatus::kTiltTooLarge);
  EXPECT_NE(found.reason.find("leans by 3.0 deg"), std::string::npos) << found.reason;
}

TEST(LeastTilt, AnArmOfAnyBuildTellsWhatIsOutOfReachAndWhichLimitIsPassed) {
  Arm arm = shipped("tsm-cobra-arm.yaml");
  std::mt19937_64 random(36);
  TiltedGoal tilted = tiltedGoalOf(arm, 0, random);
  for (auto& row : arm.rows)
    if (row.joint.name == "q1") row.joint.lower = tilted.q[0] + 0.6, row.joint.upper = tilted.q[0] + 0.7;
  const auto limited = solveInverseKinematics(arm, tilted.goal, kToolLoad, kDown);
  EXPECT_EQ(limited.status, BranchStatus::kPastJointLimit);
  EXPECT_NE(limited.reason.find("q1"), std::string::npos) << limited.reason;
  tilted.goal.p_BT *= 5;
  EXPECT_EQ(solveInverseKinematics(arm, tilted.goal, kToolLoad, kDown).status, BranchStatus::kOutOfReach);
}

}  // namespace
}  // namespace tubeplan::deflection
