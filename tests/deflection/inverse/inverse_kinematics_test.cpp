// Flexible inverse kinematics must find every branch, upright or upside down, and state why a goal cannot be met.
#include <gtest/gtest.h>

#include <algorithm>

#include "deflection/inverse/inverse_solver.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns the goal that a posture meets on the flexible arm: its deflected tip and tool axis.
ToolGoal goalOf(const Arm& arm, const Eigen::VectorXd& q, double load, const Eigen::Vector3d& gravity_B) {
  const auto shape = solveFlexibleKinematics(arm, {q, load, gravity_B}, {1e-14, 100});
  return {shape.X_BD.p, shape.X_BD.R * arm.tool_axis_L};
}

bool holds(const InverseKinematics& found, const Eigen::VectorXd& q) {
  for (const auto& branch : found.branches)
    if (branch.status == BranchStatus::kConverged && (branch.q - q).cwiseAbs().maxCoeff() < 1e-7) return true;
  return false;
}

void everyPostureIsFoundAgain(const Eigen::Vector3d& gravity_B) {
  const Arm arm = cobraArm();
  std::mt19937_64 random(21);
  int tried = 0;
  for (int n = 0; n < 300; ++n) {
    const auto q = randomJoints(arm, random);
    if (std::abs(std::sin(q[2])) < 0.1) continue;  // near a stretched elbow, two branches nearly coincide
    const ToolGoal goal = goalOf(arm, q, 90, gravity_B);
    const auto found = solveInverseKinematics(arm, goal, 90, gravity_B);
    bool singular = false;
    for (const auto& branch : found.branches) singular = singular || branch.status == BranchStatus::kSingular;
    if (singular) continue;
    ++tried;
    EXPECT_TRUE(holds(found, q)) << "posture " << n << ": " << q.transpose() / kDegree;
    for (const auto& branch : found.branches) {
      if (branch.status != BranchStatus::kConverged) continue;
      const auto again = goalOf(arm, branch.q, 90, gravity_B);
      EXPECT_LE((again.p_BT - goal.p_BT).norm(), 1e-9);
      EXPECT_LE(branch.tilt, 0.2);
    }
  }
  EXPECT_GT(tried, 150);
}

TEST(InverseKinematics, EveryPostureIsFoundAgain) { everyPostureIsFoundAgain(-Eigen::Vector3d::UnitZ()); }
TEST(InverseKinematics, EveryPostureIsFoundAgainUpsideDown) { everyPostureIsFoundAgain(Eigen::Vector3d::UnitZ()); }

/// Each goal of a batch must get the result that it gets alone, even if other goals are out of reach, at a stretched
/// elbow or NaN.
TEST(InverseSolver, SolvesEachGoalAsIfItWereAlone) {
  std::mt19937_64 random(22);
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  for (const Arm& arm : {cobraArm(), withEffect(cobraArm(), "joint-offset", "theta1", {0.002})}) {
    std::vector<ToolGoal> goals;
    for (int n = 0; n < 37; ++n) goals.push_back(goalOf(arm, randomJoints(arm, random), 90, down));
    goals[5].p_BT *= 3;
    goals[11] = goalOf(arm, Eigen::Vector4d(10, 60, 0.3, -40) * kDegree, 90, down);
    goals[17].p_BT.x() = std::numeric_limits<double>::quiet_NaN();
    InverseSolver solver(arm, 90, down);
    const auto together = solver.solve(goals);
    ASSERT_EQ(together.size(), goals.size());
    for (std::size_t k = 0; k < goals.size(); ++k) {
      const auto alone = solveInverseKinematics(arm, goals[k], 90, down);
      EXPECT_EQ(together[k].status, alone.status) << k;
      ASSERT_EQ(together[k].branches.size(), alone.branches.size()) << k;
      for (std::size_t b = 0; b < alone.branches.size(); ++b) {
        EXPECT_EQ(together[k].branches[b].status, alone.branches[b].status) << k;
        if (alone.branches[b].status == BranchStatus::kConverged) {
          EXPECT_EQ(together[k].branches[b].q, alone.branches[b].q) << k;
        }
      }
    }
    EXPECT_EQ(together[5].status, BranchStatus::kOutOfReach);
    EXPECT_NE(together[17].status, BranchStatus::kConverged);
  }
}

/// If both converge, the kernels and the general solver must find the same readings, tilt and singular value from the
/// same start.
TEST(InverseSolver, AgreesWithTheGeneralSteps) {
  std::mt19937_64 random(23);
  const Arm arm = cobraArm(), general = withEffect(arm, "contact-force", "tip", {1e-200});
  const Eigen::Vector3d gravity_B = randomDirection(random);
  int compared = 0;
  for (int n = 0; n < 60; ++n) {
    const Eigen::VectorXd q = randomJoints(arm, random);
    if (std::abs(std::sin(q[2])) < 0.1) continue;
    const ToolGoal goal = goalOf(arm, q, 90, gravity_B);
    const Eigen::VectorXd start = q + 0.03 * Eigen::Vector4d(1, -1, 1, -1);
    const Branch a = refineBranch(arm, goal, 90, gravity_B, start),
                 b = refineBranch(general, goal, 90, gravity_B, start);
    if (a.status != BranchStatus::kConverged || b.status != BranchStatus::kConverged) continue;
    ++compared;
    EXPECT_LE((a.q - b.q).norm(), 1e-8) << n;
    EXPECT_NEAR(a.tilt, b.tilt, 1e-8) << n;
    EXPECT_NEAR(a.smallest_singular_value, b.smallest_singular_value, 1e-6) << n;
    EXPECT_LE(a.position_error, InverseKinematicsOptions{}.position_tolerance) << n;
  }
  EXPECT_GT(compared, 40);
}

TEST(InverseKinematics, TellsWhatIsOutOfReach) {
  const auto found =
      solveInverseKinematics(cobraArm(), {{3, 0, 0}, Eigen::Vector3d::UnitZ()}, 0, -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(found.status, BranchStatus::kOutOfReach);
  EXPECT_FALSE(found.reason.empty());
}

TEST(InverseKinematics, TellsWhichLimitIsPassed) {
  Arm arm = cobraArm();
  const Eigen::Vector4d q = Eigen::Vector4d(-36, 80, -60, -20) * kDegree;
  const ToolGoal goal = goalOf(arm, q, 0, -Eigen::Vector3d::UnitZ());
  for (auto& row : arm.rows)
    if (row.joint.name == "theta1") row.joint.lower = -30 * kDegree, row.joint.upper = 120 * kDegree;
  const auto found = solveInverseKinematics(arm, goal, 0, -Eigen::Vector3d::UnitZ());
  ASSERT_EQ(found.status, BranchStatus::kPastJointLimit);
  EXPECT_NE(found.reason.find("theta1"), std::string::npos);
}

TEST(InverseKinematics, TellsASingularPosture) {
  const Arm arm = cobraArm();
  const Eigen::Vector4d q = Eigen::Vector4d(10, 60, 0.3, -40) * kDegree;  // the elbow is stretched
  const auto branch = refineBranch(arm, goalOf(arm, q, 0, -Eigen::Vector3d::UnitZ()), 0, -Eigen::Vector3d::UnitZ(), q);
  EXPECT_EQ(branch.status, BranchStatus::kSingular);
  EXPECT_LT(branch.smallest_singular_value, 0.01);
}

TEST(InverseKinematics, ReportsTheTiltThatFourJointsCannotCorrect) {
  const Arm arm = cobraArm();
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  const auto found =
      solveInverseKinematics(arm, {Eigen::Vector3d(40, -30, 44) * kInch, Eigen::Vector3d::UnitZ()}, 0, down);
  ASSERT_EQ(found.status, BranchStatus::kConverged);
  // The platform is tilted by 1.37 deg relative to the beam; four joints cannot correct all of this tilt and of the
  // sag.
  EXPECT_GT(found.branches.front().tilt, 0.1 * kDegree);
  EXPECT_LT(found.branches.front().tilt, 2 * kDegree);
}

TEST(InverseKinematics, AReadingThatIsScaledIsSolvedForInItsOwnTurn) {
  Arm arm = withEffect(cobraArm(), "joint-scale", "theta4", {0.01});
  arm = withEffect(arm, "base-slip", "base", {0.004, -0.003, 0.002, 0.005, 0});
  arm = withEffect(arm, "backlash", "tool.z", {0.002});
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  const Eigen::Vector4d q = Eigen::Vector4d(20, 80, -60, -70) * kDegree;
  const ToolGoal goal = goalOf(arm, q, 60, down);
  const double turn = 2 * std::numbers::pi;
  for (double away : {0., turn, -turn}) {
    const auto branch = refineBranch(arm, goal, 60, down, q + away * Eigen::Vector4d::UnitW());
    ASSERT_EQ(branch.status, BranchStatus::kConverged) << away << ": " << branch.reason;
    EXPECT_LE((branch.q - q).norm(), 1e-8) << away;
  }
  const auto found = solveInverseKinematics(arm, goal, 60, down);
  ASSERT_EQ(found.status, BranchStatus::kConverged);
  for (const auto& branch : found.branches) {
    if (branch.status != BranchStatus::kConverged) continue;
    EXPECT_LE((solveFlexibleKinematics(arm, {branch.q, 60, down}).X_BD.p - goal.p_BT).norm(), 1e-8);
  }
}

TEST(InverseKinematics, AnArmOfSixJointsMeetsPlaceAndAxis) {
  Arm arm;
  arm.name = "six";
  const double d[6][3] = {{0, 0, .4}, {-90, 0, 0}, {0, .45, 0}, {-90, 0, .42}, {90, 0, 0}, {-90, 0, .1}};
  for (int k = 0; k < 6; ++k) {
    Row<double> row;
    row.name = "link" + std::to_string(k + 1);
    row.placement = DenavitHartenberg<double>{d[k][0] * kDegree, d[k][1], d[k][2], 0};
    row.joint.name = "J" + std::to_string(k + 1);
    row.joint.type = JointType::kRevolute;
    row.joint.lower = -3;
    row.joint.upper = 3;
    row.weight.end = 20;
    if (k == 1 || k == 2) row.joint_stiffness[2] = 2e4;
    arm.rows.push_back(row);
  }
  arm.p_LT = {0.02, 0, 0.15};
  ASSERT_FALSE(isTurretArm(arm));
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  std::mt19937_64 random(5);
  for (int n = 0; n < 10; ++n) {
    const ToolGoal goal = goalOf(arm, randomJoints(arm, random), 50, down);
    const auto found = solveInverseKinematics(arm, goal, 50, down);
    ASSERT_EQ(found.status, BranchStatus::kConverged) << n;
    EXPECT_LE(found.branches.front().position_error, 1e-6);
    EXPECT_LE(found.branches.front().tilt, 1e-5);
  }
}

/// Returns an arm of three joints with skew axes: prismatic where `slides` is true, else revolute.
Arm threeJoints(const std::array<bool, 3>& slides) {
  Arm arm;
  arm.name = "three";
  const Eigen::Vector3d turned[3] = {{0, 70 * kDegree, 0}, {-60 * kDegree, 0, 0}, {30 * kDegree, -80 * kDegree, 0}};
  for (int k = 0; k < 3; ++k) {
    auto& row = arm.rows.emplace_back();
    row.name = row.joint.name = "J" + std::to_string(k + 1);
    row.placement = Origin<double>{{0.1 * k, 0.2, 0.3}, turned[k]};
    row.joint.type = slides[static_cast<std::size_t>(k)] ? JointType::kPrismatic : JointType::kRevolute;
    row.joint.lower = -1;
    row.joint.upper = 1;
  }
  arm.p_LT = {0.3, 0.2, 0.1};
  return arm;
}

/// Returns true if q is among the branches that are usable or reported as singular.
bool isAmong(const InverseKinematics& found, const Eigen::VectorXd& q) {
  return std::ranges::any_of(found.branches, [&](const Branch& branch) {
    return (branch.status == BranchStatus::kConverged || branch.status == BranchStatus::kSingular) &&
           (branch.q - q).cwiseAbs().maxCoeff() < 1e-5;
  });
}

TEST(InverseKinematics, ArmsOfThreeSlidesAndTurnsFindTheirPosturesAgain) {
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  std::mt19937_64 random(7);
  for (unsigned mask = 0; mask < 8; ++mask) {
    const Arm arm = threeJoints({(mask & 1U) != 0, (mask & 2U) != 0, (mask & 4U) != 0});
    for (int n = 0; n < 20; ++n) {
      const auto q = randomJoints(arm, random);
      EXPECT_TRUE(isAmong(solveInverseKinematics(arm, goalOf(arm, q, 0, down), 0, down), q))
          << "slides " << mask << ", posture " << n;
    }
  }
}

}  // namespace
}  // namespace tubeplan::deflection
