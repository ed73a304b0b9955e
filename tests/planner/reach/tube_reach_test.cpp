#include "planner/reach/tube_reach.hpp"

#include <gtest/gtest.h>

#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::holeOf;
using testing::mockup;
using testing::obstacleInInches;
using testing::withObstacle;

int tubeAt(const Workcell& cell, const char* name) { return testing::tubesOf(cell, name).front(); }

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(ReachTube, UsableBranchesAreClearAtTheHoleAndAllTheWayUp) {
  const Workcell cell = mockup();
  const ArmClearance clearance(cell);
  const TubeReachOptions options;
  for (int tube : testing::tubesOf(cell, "spread:8,-R39C58")) {
    const TubeReach reach = reachTube(clearance, tube, options);
    ASSERT_EQ(reach.status, ReachStatus::kReachable) << reach.reason;
    EXPECT_EQ(reach.tube, tube);
    EXPECT_TRUE(reach.reason.empty());
    for (const auto& branch : reach.branches) {
      EXPECT_LT((testing::deflectedTip(cell, branch.q) - holeOf(cell, tube)).norm(), 1e-6 * kInch);
      EXPECT_GE(clearance.at(branch.approach.front(), ContactRule::kTravel).margin, options.spare);
      for (std::size_t k = 0; k + 1 < branch.approach.size(); ++k)
        EXPECT_GE(testing::leastSampled(
                      branch.approach[k], branch.approach[k + 1],
                      [&](const VectorXd& q) { return clearance.at(q, ContactRule::kApproach); }, 100),
                  options.spare);
    }
  }
}

TEST(ReachTube, ATubeBehindTheBaseIsPastTheFirstJointsLimit) {
  const Workcell cell = mockup();
  const TubeReach reach = reachTube(ArmClearance(cell), tubeAt(cell, "R39C58"));
  EXPECT_EQ(reach.status, ReachStatus::kUnreachable);
  EXPECT_TRUE(reach.branches.empty());
  expectContains(reach.reason, "past the limit of joint theta1");
  EXPECT_TRUE(reach.blocking.body.empty());
}

TEST(ReachTube, ABaseTooFarAwayIsOutOfReach) {
  Workcell cell = mockup();
  cell.X_WB.translation().x() += 2;
  const TubeReach reach = reachTube(ArmClearance(cell), tubeAt(cell, "R10C20"));
  EXPECT_EQ(reach.status, ReachStatus::kUnreachable);
  expectContains(reach.reason, "reach");
}

TEST(ReachTube, ABoxUnderTheHoleIsNamedWithWhatComesTooNear) {
  const Workcell cell = mockup();
  const int tube = tubeAt(cell, "R10C40");
  const Vector3d hole = holeOf(cell, tube) / kInch;
  ASSERT_EQ(reachTube(ArmClearance(cell), tube).status, ReachStatus::kReachable);
  const Workcell blocked = withObstacle(cell, obstacleInInches("crate", "box", {hole.x(), hole.y(), -6, 1, 1, 4}));
  const TubeReach reach = reachTube(ArmClearance(blocked), tube);
  EXPECT_EQ(reach.status, ReachStatus::kUnreachable);
  expectContains(reach.reason, "collision below the hole: ");
  expectContains(reach.reason, " comes too near crate");
  EXPECT_EQ(reach.blocking.other, "crate");
  EXPECT_LT(reach.blocking.margin, 0);
}

TEST(ReachTube, WhatIsMetOnlyOnTheWayUpBlocksTheApproach) {
  // A small ball is placed above the middle of each branch's horizontal tool, half an inch away at the standoff. The
  // approach rises by an inch, so the tool meets the ball.
  const Workcell cell = mockup();
  const int tube = tubeAt(cell, "R20C40");
  const TubeReach before = reachTube(ArmClearance(cell), tube);
  ASSERT_EQ(before.status, ReachStatus::kReachable);
  Workcell blocked = cell;
  for (const auto& branch : before.branches) {
    const auto frames = bodyFrames(cell, branch.approach.front(), nullptr);
    const Vector3d middle = frames[5] * Vector3d(8 * kInch, 0, 0) / kInch;
    const double height = middle.z() + 1.75 + 0.25 + 0.5 + 0.1;
    const std::string name = "ball-" + std::to_string(&branch - before.branches.data());
    blocked = withObstacle(blocked, obstacleInInches(name, "sphere", {middle.x(), middle.y(), height, 0.1}));
  }
  const TubeReach reach = reachTube(ArmClearance(blocked), tube);
  EXPECT_EQ(reach.status, ReachStatus::kUnreachable);
  expectContains(reach.reason, "approach blocked: tool comes too near ball-");
}

TEST(ReachTube, TheSpareIsKeptInHand) {
  const Workcell cell = mockup();
  const int tube = tubeAt(cell, "R10C40");
  TubeReachOptions greedy;
  greedy.spare = 1;  // [m]; no posture has this much clearance
  EXPECT_EQ(reachTube(ArmClearance(cell), tube, greedy).status, ReachStatus::kUnreachable);
}

TEST(ReachTube, TheSmallestClearStandoffOfThoseGivenIsTaken) {
  const Workcell cell = mockup();
  const ArmClearance clearance(cell);
  TubeReachOptions options;
  options.standoff_shares = {0.05, 0.3, 0.4, 0.6, 1};
  int shorter = 0;
  for (const char* name : {"R10C40", "R30C57", "R45C50", "R5C10", "R20C100"}) {
    const int tube = tubeAt(cell, name);
    const TubeReach usual = reachTube(clearance, tube), least = reachTube(clearance, tube, options);
    ASSERT_EQ(usual.status, least.status) << name;
    if (least.status != ReachStatus::kReachable) continue;
    const auto depthOf = [&](const TubeBranch& branch) {
      return holeOf(cell, tube).z() - testing::deflectedTip(cell, branch.approach.front()).z();
    };
    const double depth = depthOf(least.branches.front());
    EXPECT_LE(depth, depthOf(usual.branches.front()) + 1e-6);
    shorter += depth < 0.7 * depthOf(usual.branches.front());
    for (const double share : options.standoff_shares) {
      if (share * options.compensation.standoff > depth - 1e-6) break;
      TubeReachOptions alone;
      alone.standoff_shares = {share};
      EXPECT_NE(reachTube(clearance, tube, alone).status, ReachStatus::kReachable) << name << " " << share;
    }
  }
  EXPECT_GE(shorter, 3);
}

TEST(ReachTube, EveryModeIsJudgedByTheFlexibleShape) {
  const Workcell cell = mockup();
  const int tube = tubeAt(cell, "R10C40");
  for (const auto mode : {Compensation::kNone, Compensation::kGoalPoint, Compensation::kViaPoint}) {
    TubeReachOptions options;
    options.compensation.mode = mode;
    const TubeReach reach = reachTube(ArmClearance(cell), tube, options);
    ASSERT_EQ(reach.status, ReachStatus::kReachable) << nameOf(mode) << reach.reason;
    const double off = (testing::deflectedTip(cell, reach.branches.front().q) - holeOf(cell, tube)).norm();
    if (mode == Compensation::kNone)
      EXPECT_GT(off, 0.05 * kInch);
    else
      EXPECT_LT(off, 1e-6 * kInch);
  }
}

}  // namespace
}  // namespace tubeplan::planner
