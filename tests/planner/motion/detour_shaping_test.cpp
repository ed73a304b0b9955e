#include "planner/motion/detour_shaping.hpp"

#include <gtest/gtest.h>

#include "planner/timing/flowing_timing.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector2d, Eigen::Vector4d, Eigen::VectorXd;
using testing::kFourJoints, testing::kTwoJoints;
using testing::leastSampled;
using testing::shape;

JointSpeeds speedsOf(int joints) { return {VectorXd::Constant(joints, 0.5), VectorXd::Constant(joints, 1)}; }

void expectFreeFlow(const MotionPlan& plan, const MotionProblem& problem) {
  ASSERT_EQ(plan.status, MotionPlanStatus::kFree) << plan.reason;
  ASSERT_TRUE(plan.flows);
  const auto corners = cornersOf(timeFlow(plan.waypoints, *problem.speeds));
  for (std::size_t k = 1; k < corners.size(); ++k)
    EXPECT_GE(leastSampled(corners[k - 1], corners[k], problem.clearance_of, 300), plan.proved_margin);
  EXPECT_GE(plan.proved_margin, 0);
  EXPECT_NEAR(plan.cost, flowTime(plan.waypoints, problem), 1e-12);
}

TEST(DetourShaping, FlowsRoundAPostQuickerThanWithRest) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  auto problem = kTwoJoints.problem(world);
  const Vector2d q0(-0.6, 0), q1(0.6, 0);
  const auto resting = planMotion(q0, q1, problem);
  problem.speeds = speedsOf(2);
  problem.cost = [&](const VectorXd& a, const VectorXd& b) { return straightMoveDuration(a, b, *problem.speeds); };
  const auto flowing = planMotion(q0, q1, problem);
  expectFreeFlow(flowing, problem);
  EXPECT_EQ(flowing.waypoints.front(), q0);
  EXPECT_EQ(flowing.waypoints.back(), q1);
  double time = 0;
  for (std::size_t k = 1; k < resting.waypoints.size(); ++k)
    time += straightMoveDuration(resting.waypoints[k - 1], resting.waypoints[k], *problem.speeds);
  EXPECT_LT(flowing.cost, time - 0.1);
  EXPECT_GE(flowing.cost, moveDuration(q0, q1, *problem.speeds));
}

TEST(DetourShaping, RandomClutterNeverBreaksTheProof) {
  std::mt19937_64 random(11);
  int flows = 0;
  for (int k = 0; k < 30; ++k) {
    const double x = testing::uniform(random, 0.9, 1.25), y = testing::uniform(random, -0.4, 0.4);
    const CollisionWorld world(kFourJoints.scene({{"post", shape("cylinder", {x, y, -1, x, y, 1, 0.08}), {}}}));
    auto problem = kFourJoints.problem(world);
    problem.speeds = speedsOf(4);
    const Vector4d q0(-0.9, 0.2, 0.1, 0), q1(0.9, -0.2, 0.1, 0);
    if (problem.clearance_of(q0).margin < 0 || problem.clearance_of(q1).margin < 0) continue;
    const auto plan = planMotion(q0, q1, problem, {.seed = static_cast<std::uint64_t>(k)});
    if (plan.status != MotionPlanStatus::kFree || plan.straight) continue;
    EXPECT_EQ(plan.waypoints, planMotion(q0, q1, problem, {.seed = static_cast<std::uint64_t>(k)}).waypoints);
    if (!plan.flows) continue;
    ++flows;
    expectFreeFlow(plan, problem);
  }
  EXPECT_GE(flows, 10);
}

TEST(DetourShaping, QuickeningNeverCostsTimeNorMovesTheEnds) {
  const CollisionWorld world(
      kFourJoints.scene({{"post", shape("cylinder", {1.15, 0.05, -1, 1.15, 0.05, 1, 0.1}), {}}}));
  auto problem = kFourJoints.problem(world);
  problem.speeds = speedsOf(4);
  const Vector4d q0(-0.9, 0.2, 0.1, 0), q1(0.9, 0.2, 0.1, 0);
  long checks = 0;
  Waypoints way = detourByOnePosture(q0, q1, problem, {}, checks);
  ASSERT_EQ(way.size(), 3u);
  const double before = flowTime(way, problem);
  quicken(way, problem, {}, checks);
  EXPECT_LE(flowTime(way, problem), before);
  EXPECT_EQ(way.front(), q0);
  EXPECT_EQ(way.back(), q1);
  EXPECT_EQ(checkFlow(way, problem, {}, checks).status, MotionCheckStatus::kFree);
}

TEST(DetourShaping, ABoxedInGoalHasNoWayByOnePosture) {
  const CollisionWorld world(kTwoJoints.scene({{"wall", shape("box", {0.9, 0, 0, 0.6, 0.02, 2, 0, 0, 0}), {}}}));
  auto problem = kTwoJoints.problem(world);
  problem.lower = Vector2d(-0.7, -0.05);
  problem.upper = Vector2d(0.7, 0.05);
  problem.speeds = speedsOf(2);
  long checks = 0;
  EXPECT_TRUE(detourByOnePosture(Vector2d(-0.6, 0), Vector2d(0.6, 0), problem, {}, checks).empty());
  EXPECT_EQ(planMotion(Vector2d(-0.6, 0), Vector2d(0.6, 0), problem).status, MotionPlanStatus::kNoPath);
}

}  // namespace
}  // namespace tubeplan::planner
