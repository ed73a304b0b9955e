// On arms whose last three axes meet in one point, every posture must be found if the tool's rotation about its axis is
// given, and no false posture.
#include "deflection/inverse/wrist_branches.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "deflection/inverse/goal_newton.hpp"
#include "deflection/inverse/rigid_search.hpp"
#include "tests/deflection/inverse/drawn_chain.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::postureDifference, testing::kQuarter, testing::DrawnChain, testing::chainOf, testing::Draw,
    testing::drawnReadings;
/// Returns a chain of `before` joints of any geometry (with the third axis parallel to the second if `is_plane`) and a
/// wrist whose axes miss each other by `off` [m].
DrawnChain drawnWrist(int before, int slide, bool is_plane, double off, Draw& draw) {
  std::vector<DenavitHartenberg<double>> rows;
  for (int k = 0; k <= before; ++k) rows.push_back({0.8 + draw(0.7), 0.3 + draw(0.2), draw(0.3), 0});
  if (is_plane) rows[2].alpha = 0;
  rows.push_back({kQuarter + draw(0.5), off, 0, 0});
  rows.push_back({-kQuarter + draw(0.5), 0, off, 0});
  return chainOf(rows, slide, draw.vector(0.3));
}

/// Returns a PUMA 560 on a level base. `tip` [m] may lie off the last axis.
DrawnChain levelPuma(const Vector3d& tip) {
  return chainOf({{0, 0, 0, 0},
                  {-kQuarter, 0, 0.2435, 0},
                  {0, 0.4318, -0.0934, 0},
                  {kQuarter, -0.0203, 0.4331, 0},
                  {-kQuarter, 0, 0, 0},
                  {kQuarter, 0, 0, 0}},
                 -1, tip);
}

ToolGoal goalAt(const DrawnChain& chain, const VectorXd& q) {
  TipMotion tip;
  placeRigidTip(chain.axes, q, tip);
  return {tip.p, tip.axis};
}

double offFrom(const DrawnChain& chain, const ToolGoal& goal, const VectorXd& q) {
  const ToolGoal at = goalAt(chain, q);
  return std::max((at.p_BT - goal.p_BT).norm(), (at.axis_B - goal.axis_B).norm());
}

bool hasNear(const DrawnChain& chain, const std::vector<VectorXd>& postures, const VectorXd& q, double most) {
  return std::ranges::any_of(postures,
                             [&](const VectorXd& other) { return postureDifference(chain, other, q) < most; });
}

TEST(WristBranches, EveryPostureIsFoundAtItsTurnAndNoneIsFalse) {
  Draw draw(7);
  int count = 0;
  for (int n = 0; n < 300; ++n) {
    const int before = n % 3 == 2 ? 4 : 3;
    const DrawnChain chain = drawnWrist(before, n % 5 == 4 ? n % 3 : -1, n % 3 == 1, 0, draw);
    ASSERT_TRUE(carriesWrist(chain.axes, reachOf(chain.arm)));
    const VectorXd q = drawnReadings(chain, draw);
    const ToolGoal goal = goalAt(chain, q);
    const RigidSearch search(chain.arm, chain.axes);
    std::vector<VectorXd> like, all;
    search.addPosturesLike(goal, q, like);
    EXPECT_TRUE(hasNear(chain, like, q, 1e-3)) << n;
    for (const VectorXd& other : like) EXPECT_LT(offFrom(chain, goal, other), 0.01 * reachOf(chain.arm)) << n;
    search.addPostures(goal, all);
    count += static_cast<int>(all.size());
  }
  EXPECT_GT(count, 300 * 24);
}

TEST(WristBranches, AxesThatMissEachOtherALittleGiveStartsThatLeadToThePosture) {
  Draw draw(8);
  int missed = 0;
  for (int n = 0; n < 100; ++n) {
    const DrawnChain chain = drawnWrist(3, -1, n % 2 == 1, 3e-4, draw);
    ASSERT_TRUE(carriesWrist(chain.axes, reachOf(chain.arm)));
    const VectorXd q = drawnReadings(chain, draw);
    const ToolGoal goal = goalAt(chain, q);
    std::vector<VectorXd> like;
    RigidSearch(chain.arm, chain.axes).addPosturesLike(goal, q, like);
    missed += !hasNear(chain, like, q, 0.05);
  }
  EXPECT_LE(missed, 3);  // a few may be missed, because postures that nearly coincide are less accurate
}

TEST(WristBranches, AxesThatDoNotMeetAreNoWrist) {
  Draw draw(9);
  EXPECT_FALSE(carriesWrist(drawnWrist(3, -1, false, 0.05, draw).axes, 1.5));
  EXPECT_FALSE(carriesWrist(drawnWrist(3, 4, false, 0, draw).axes, 1.5));
}

// If the last axis is in line with the third-to-last, these two joints can rotate against each other without moving the
// tool. Such postures meet the goal at a single roll of the tool, which lies between the sampled rolls, and must be
// found nevertheless.
TEST(WristBranches, PosturesInLineAreFoundBetweenTheRolls) {
  const DrawnChain chain = levelPuma({0.04, 0, 0.22});
  const RigidSearch search(chain.arm, chain.axes);
  for (const double q2 : {-0.9, -0.5, 0.1})
    for (const double q4 : {-2.5, -1., 0.3, 1.7}) {
      const VectorXd q{{0.4, q2, -q2, q4, 0, 0.6}};  // the third-to-last axis is vertical
      const ToolGoal goal = goalAt(chain, q);
      std::vector<VectorXd> all;
      search.addPostures(goal, all);
      const auto isNear = [&](const VectorXd& other) {
        return std::abs(other[4]) < 1e-6 && std::abs(std::remainder(other[3] - q4, 4 * kQuarter)) < 0.6 &&
               postureDifference(chain, other.head<3>(), q.head<3>()) < 0.05 && offFrom(chain, goal, other) < 0.005;
      };
      EXPECT_TRUE(std::ranges::any_of(all, isNear)) << q.transpose();
    }
}

TEST(WristBranches, AJointThatOnlyTurnsTheToolInPlaceTakesTheRollsAsReadings) {
  const DrawnChain chain = levelPuma({0, 0, 0.22});
  const VectorXd q{{0.4, -0.7, 0.2, 0.5, 0.9, 1.1}};
  std::vector<VectorXd> all;
  RigidSearch(chain.arm, chain.axes).addPostures(goalAt(chain, q), all);
  std::vector<double> last;
  for (const VectorXd& other : all) {
    EXPECT_LT(offFrom(chain, goalAt(chain, q), other), 1e-6);
    last.push_back(other[5]);
  }
  std::ranges::sort(last);
  const auto repeated = std::ranges::unique(last);
  EXPECT_EQ(std::distance(last.begin(), repeated.begin()), 24);
}

TEST(LeadToGoals, SideBySideIsAsOneByOne) {
  Draw draw(10);
  const DrawnChain chain = drawnWrist(3, -1, false, 0, draw);
  const InverseKinematicsOptions options;
  GoalProblem problem(chain.arm, false, rigidTips(chain.axes), options);
  std::vector<ToolGoal> goals;
  std::vector<VectorXd> starts;
  for (int k = 0; k < 100; ++k) {
    goals.push_back(goalAt(chain, drawnReadings(chain, draw)));
    starts.push_back(drawnReadings(chain, draw));
  }
  const auto together = leadToGoals(problem, goals, starts);
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const Branch alone = leadToGoals(problem, std::span(&goals[k], 1), std::span(&starts[k], 1)).front();
    EXPECT_EQ(alone.status, together[k].status);
    EXPECT_EQ(alone.q, together[k].q);
    EXPECT_EQ(alone.iterations, together[k].iterations);
  }
}

}  // namespace
}  // namespace tubeplan::deflection
