#include "planner/reach/compensation.hpp"

#include <gtest/gtest.h>

#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using deflection::BranchStatus;
using Eigen::Vector3d, Eigen::VectorXd;
using testing::deflectedTip;
using testing::holeOf;
using testing::mockup;
using testing::sideways;

std::vector<TubeBranch> convergedFor(const Workcell& cell, int tube, Compensation mode) {
  CompensationOptions options;
  options.mode = mode;
  auto branches = compensate(cell, holeOf(cell, tube), options);
  std::erase_if(branches, [](const TubeBranch& branch) { return branch.status != BranchStatus::kConverged; });
  return branches;
}

/// Returns the largest distance [m] of the tip from the hole's axis, sampled at 100 postures per path segment.
double sampledDeviation(const Workcell& cell, const Vector3d& hole, const std::vector<VectorXd>& postures) {
  double worst = 0;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k)
    for (int s = 0; s <= 100; ++s)
      worst =
          std::max(worst, sideways(deflectedTip(cell, postures[k] + s / 100. * (postures[k + 1] - postures[k])), hole));
  return worst;
}

/// Returns the deflection of the tip [m] at joint readings q.
Vector3d deflectionAt(const Workcell& cell, const VectorXd& q) {
  return deflectedTip(cell, q) - deflectedTip(testing::rigid(cell), q);
}

class EachTube : public ::testing::Test {
 protected:
  const Workcell cell = mockup();
  const std::vector<int> tubes = testing::tubesOf(cell, "spread:8,-R39C58");
};

TEST(CompensationNames, GoForthAndBack) {
  for (const auto mode : {Compensation::kNone, Compensation::kGoalPoint, Compensation::kViaPoint})
    EXPECT_EQ(findCompensation(nameOf(mode)), mode);
  EXPECT_FALSE(findCompensation("via"));
  EXPECT_EQ(nameOf(Compensation::kGoalPoint), "goal-point");
}

TEST_F(EachTube, ViaPointsBringTheDeflectedTipToTheCentreAlongTheAxis) {
  int branches = 0;
  for (int tube : tubes)
    for (const auto& branch : convergedFor(cell, tube, Compensation::kViaPoint)) {
      ++branches;
      const Vector3d hole = holeOf(cell, tube);
      EXPECT_LT((deflectedTip(cell, branch.q) - hole).norm(), 1e-6 * kInch);
      EXPECT_LT((branch.predicted_tip_W - deflectedTip(cell, branch.q)).norm(), 1e-11);
      ASSERT_GE(branch.approach.size(), 3u);
      EXPECT_EQ(branch.approach.back(), branch.q);
      EXPECT_NEAR(deflectedTip(cell, branch.approach.front()).z(), -1.0 * kInch, 1e-6 * kInch);
      for (const auto& via : branch.approach) {
        EXPECT_LT(sideways(deflectedTip(cell, via), hole), 1e-6 * kInch);
        EXPECT_TRUE(testing::withinLimits(cell.arm, via));
      }
      EXPECT_LE(sampledDeviation(cell, hole, branch.approach), 0.0011 * kInch);
      EXPECT_LE(branch.path_deviation, 0.001001 * kInch);
    }
  EXPECT_GE(branches, 8);
}

TEST_F(EachTube, GoalPointHasTheSameJointsAtTheGoal) {
  for (int tube : tubes) {
    const auto via = convergedFor(cell, tube, Compensation::kViaPoint),
               goal = convergedFor(cell, tube, Compensation::kGoalPoint);
    ASSERT_EQ(via.size(), goal.size());
    for (std::size_t k = 0; k < via.size(); ++k) {
      EXPECT_EQ(via[k].q, goal[k].q);
      EXPECT_EQ(via[k].tilt, goal[k].tilt);
    }
  }
}

TEST_F(EachTube, GoalPointLeavesTheAxisByTheChangeOfDeflectionOnTheWay) {
  double most = 0;
  for (int tube : tubes)
    for (const auto& branch : convergedFor(cell, tube, Compensation::kGoalPoint)) {
      const Vector3d hole = holeOf(cell, tube), at_goal = deflectionAt(cell, branch.q);
      for (const auto& via : branch.approach)
        EXPECT_NEAR(sideways(deflectedTip(cell, via), hole), sideways(deflectionAt(cell, via), at_goal), 1e-7 * kInch);
      EXPECT_GE(branch.path_deviation, sideways(deflectionAt(cell, branch.approach.front()), at_goal) - 1e-7 * kInch);
      most = std::max(most, branch.path_deviation);
    }
  EXPECT_GT(most, 0.003 * kInch);
}

TEST_F(EachTube, WithoutCompensationTheTipMissesByTheSagAllTheWay) {
  for (int tube : tubes)
    for (const auto& branch : convergedFor(cell, tube, Compensation::kNone)) {
      const Vector3d hole = holeOf(cell, tube);
      EXPECT_LT((deflectedTip(testing::rigid(cell), branch.q) - hole).norm(), 1e-6 * kInch);
      const Vector3d miss = branch.predicted_tip_W - hole;
      EXPECT_LT((miss - deflectionAt(cell, branch.q)).norm(), 1e-9);
      EXPECT_LT(miss.z(), -0.05 * kInch);
      EXPECT_GE(branch.path_deviation, miss.head<2>().norm() - 1e-9);
      EXPECT_LE(sampledDeviation(testing::rigid(cell), hole, branch.approach), 0.0011 * kInch);
    }
}

TEST_F(EachTube, ModesRankAsTheirDeviationsDo) {
  double sum[3] = {};
  for (int tube : tubes)
    for (const auto mode : {Compensation::kNone, Compensation::kGoalPoint, Compensation::kViaPoint})
      sum[static_cast<int>(mode)] += convergedFor(cell, tube, mode).front().path_deviation;
  EXPECT_LT(sum[2], sum[1]);
  EXPECT_LT(sum[1], sum[0]);
}

TEST_F(EachTube, AStartNearABranchFindsThatBranch) {
  std::mt19937_64 generator(5);
  for (int tube : tubes)
    for (const auto& branch : convergedFor(cell, tube, Compensation::kViaPoint)) {
      VectorXd start = branch.q;
      for (double& q : start) q += testing::uniform(generator, -0.03, 0.03);
      const TubeBranch found = compensateFrom(cell, holeOf(cell, tube), start);
      ASSERT_EQ(found.status, BranchStatus::kConverged) << found.reason;
      EXPECT_LT((found.q - branch.q).cwiseAbs().maxCoeff(), 1e-8);
    }
}

TEST_F(EachTube, TiltIsTheAngleOfTheDeflectedToolAgainstTheHole) {
  for (int tube : tubes)
    for (const auto& branch : convergedFor(cell, tube, Compensation::kViaPoint)) {
      const auto shape =
          deflection::solveFlexibleKinematics(cell.arm, {branch.q, 0, deflection::gravityInBase(cell.arm, cell.X_WB)});
      const Vector3d axis = cell.X_WB.linear() * shape.X_BD.R * cell.arm.tool_axis_L;
      EXPECT_NEAR(std::cos(branch.tilt), axis.z(), 1e-9);
      EXPECT_LT(branch.tilt, 2 * kDegree);
    }
}

TEST_F(EachTube, WithoutApproachOnlyTheGoalIsFound) {
  CompensationOptions options;
  options.with_approach = false;
  const auto branch = compensate(cell, holeOf(cell, tubes.front()), options).front();
  EXPECT_EQ(branch.status, BranchStatus::kConverged);
  EXPECT_TRUE(branch.approach.empty());
  EXPECT_EQ(branch.q, convergedFor(cell, tubes.front(), Compensation::kViaPoint).front().q);
}

TEST_F(EachTube, ALoadOnTheTipIsCompensatedToo) {
  Workcell loaded = cell;
  loaded.load = 40;
  const auto branch = convergedFor(loaded, tubes.front(), Compensation::kViaPoint).front();
  EXPECT_LT((deflectedTip(loaded, branch.q) - holeOf(cell, tubes.front())).norm(), 1e-6 * kInch);
  EXPECT_GT((deflectedTip(cell, branch.q) - holeOf(cell, tubes.front())).norm(), 0.01 * kInch);
}

TEST(Compensate, AHoleTooFarAwayHasNoBranchThatConverges) {
  const Workcell cell = mockup();
  for (const auto& branch : compensate(cell, Vector3d(3, 3, 0))) {
    EXPECT_NE(branch.status, BranchStatus::kConverged);
    EXPECT_FALSE(branch.reason.empty());
  }
}

TEST(Compensate, TooFewViaPointsForTheToleranceIsAFailureWithItsReason) {
  const Workcell cell = mockup();
  CompensationOptions options;
  options.path_tolerance = 1e-9;
  options.max_via_points = 5;
  const auto branch = compensate(cell, holeOf(cell, testing::tubesOf(cell, "R10C40").front()), options).front();
  EXPECT_EQ(branch.status, BranchStatus::kNotConverged);
  EXPECT_EQ(branch.reason, "approach: the tip leaves the hole's axis between via points");
}

TEST(LateralDeviation, IsTheDistanceFromTheAxisOfASpanOfPostures) {
  const Workcell cell = mockup();
  const VectorXd a = Eigen::Vector4d(0.2, 1.4, -1.2, 0.1);
  const Vector3d tip = deflectedTip(cell, a);
  EXPECT_NEAR(lateralDeviation(cell, tip, {a, a}), 0, 1e-9);
  EXPECT_NEAR(lateralDeviation(cell, tip + Vector3d(0.003, 0.004, 7), {a, a}), 0.005, 1e-9);
  EXPECT_EQ(lateralDeviation(cell, tip, {a}), 0);
}

}  // namespace
}  // namespace tubeplan::planner
