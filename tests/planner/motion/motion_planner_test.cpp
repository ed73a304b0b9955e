#include "planner/motion/motion_planner.hpp"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;
using testing::kFourJoints, testing::kTwoJoints;
using testing::leastSampled;
using testing::shape;
using testing::ToyArm;

void expectSound(const MotionPlan& plan, const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem) {
  ASSERT_EQ(plan.status, MotionPlanStatus::kFree) << plan.reason;
  EXPECT_EQ(plan.waypoints.front(), q0);
  EXPECT_EQ(plan.waypoints.back(), q1);
  EXPECT_GT(plan.proved_margin, 0);
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    EXPECT_GE(leastSampled(plan.waypoints[i - 1], plan.waypoints[i], problem.clearance_of, 1000), plan.proved_margin);
    EXPECT_TRUE((plan.waypoints[i].array() >= problem.lower.array()).all() &&
                (plan.waypoints[i].array() <= problem.upper.array()).all());
  }
}

TEST(PlanMotion, StraightWhereNothingIsInTheWay) {
  const CollisionWorld world(kTwoJoints.scene({{"wall", shape("keep_side", {2, 0, 0, -1, 0, 0}), {}}}));
  const auto problem = kTwoJoints.problem(world);
  const MotionPlan plan = planMotion(Vector2d(-1, 0), Vector2d(1, 0.5), problem);
  expectSound(plan, Vector2d(-1, 0), Vector2d(1, 0.5), problem);
  EXPECT_TRUE(plan.straight);
  EXPECT_EQ(plan.iterations, 0);
}

TEST(PlanMotion, GoesRoundAPostWithTwoJoints) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  const auto problem = kTwoJoints.problem(world);
  const Vector2d q0(-0.6, 0), q1(0.6, 0);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const MotionPlan plan = planMotion(q0, q1, problem, {.seed = seed});
    expectSound(plan, q0, q1, problem);
    EXPECT_FALSE(plan.straight);
    EXPECT_GT(plan.iterations, 0);
    EXPECT_LT(plan.waypoints.size(), 8u);
    EXPECT_GT(plan.cost, problem.travel(q0, q1));
  }
}

TEST(PlanMotion, GoesRoundClutterWithFourJoints) {
  const CollisionWorld world(kFourJoints.scene({{"post", shape("cylinder", {0.8, 0.05, -1, 0.8, 0.05, 1, 0.1}), {}},
                                                {"block", shape("box", {0.9, 1.2, 0, 0.3, 0.3, 0.3, 0, 0, 0}), {}},
                                                {"bowl", shape("inside_of.sphere", {0, 0, 0, 1.35}), {}}}));
  const auto problem = kFourJoints.problem(world, 2.6);
  const Vector4d q0(-0.7, 0.2, 0.1, 0), q1(0.7, -0.3, 0.2, 0);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    expectSound(planMotion(q0, q1, problem, {.seed = seed}), q0, q1, problem);
}

TEST(PlanMotion, ShorteningLowersTheCostAsked) {
  const CollisionWorld world(kFourJoints.scene({{"post", shape("cylinder", {0.8, 0.05, -1, 0.8, 0.05, 1, 0.1}), {}}}));
  auto problem = kFourJoints.problem(world, 2.6);
  problem.cost = [](const VectorXd& from, const VectorXd& to) { return 1 + (to - from).cwiseAbs().maxCoeff(); };
  const Vector4d q0(-0.7, 0.2, 0.1, 0), q1(0.7, -0.3, 0.2, 0);
  double longer = 0, shorter = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    longer += planMotion(q0, q1, problem, {.seed = seed, .shortcut_attempts = 0}).cost;
    const MotionPlan plan = planMotion(q0, q1, problem, {.seed = seed, .shortcut_attempts = 200});
    shorter += plan.cost;
    double sum = 0;
    for (std::size_t i = 1; i < plan.waypoints.size(); ++i)
      sum += problem.cost(plan.waypoints[i - 1], plan.waypoints[i]);
    EXPECT_DOUBLE_EQ(sum, plan.cost);
  }
  EXPECT_LT(shorter, longer);
}

TEST(PlanMotion, SaysHonestlyThatAWallCutsTheWay) {
  // The only joint must sweep across the plate; within its limits there is no other path.
  const ToyArm stub{{1.0}, 0.02};
  const CollisionWorld world(stub.scene({{"plate", shape("box", {0.8, 0, 0, 1.0, 1e-5, 1, 0, 0, 0}), {}}}));
  const VectorXd q0 = VectorXd::Constant(1, -0.5), q1 = VectorXd::Constant(1, 0.5);
  const MotionPlan plan = planMotion(q0, q1, stub.problem(world, 2.0), {.max_iterations = 300});
  EXPECT_EQ(plan.status, MotionPlanStatus::kNoPath);
  EXPECT_TRUE(plan.waypoints.empty());
  EXPECT_EQ(plan.iterations, 300);
  EXPECT_NE(plan.reason.find("plate"), std::string::npos) << plan.reason;
  EXPECT_NE(plan.reason.find("link1"), std::string::npos) << plan.reason;
  EXPECT_EQ(plan.tightest.other, "plate");
}

TEST(PlanMotion, SaysWhatBlocksStartOrGoal) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  const auto problem = kTwoJoints.problem(world);
  const MotionPlan start = planMotion(Vector2d(0, 0), Vector2d(1, 0), problem);
  EXPECT_EQ(start.status, MotionPlanStatus::kStartBlocked);
  EXPECT_NE(start.reason.find("link2 collides with post"), std::string::npos) << start.reason;
  const MotionPlan goal = planMotion(Vector2d(1, 0), Vector2d(0, 0), problem);
  EXPECT_EQ(goal.status, MotionPlanStatus::kGoalBlocked);
  const MotionPlan beyond = planMotion(Vector2d(1, 0), Vector2d(1, 3.5), problem);
  EXPECT_EQ(beyond.status, MotionPlanStatus::kGoalBlocked);
  EXPECT_NE(beyond.reason.find("joint 2"), std::string::npos) << beyond.reason;
}

TEST(PlanMotion, JointsWithoutLimitsAreSearchedToo) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  auto problem = kTwoJoints.problem(world);
  problem.lower.setConstant(-std::numeric_limits<double>::infinity());
  problem.upper.setConstant(std::numeric_limits<double>::infinity());
  expectSound(planMotion(Vector2d(-0.6, 0), Vector2d(0.6, 0), problem), Vector2d(-0.6, 0), Vector2d(0.6, 0), problem);
}

TEST(PlanMotion, SameSeedSameWaypointsToTheBit) {
  const CollisionWorld world(kFourJoints.scene({{"post", shape("cylinder", {0.8, 0.05, -1, 0.8, 0.05, 1, 0.1}), {}}}));
  const auto problem = kFourJoints.problem(world, 2.6);
  const Vector4d q0(-0.7, 0.2, 0.1, 0), q1(0.7, -0.3, 0.2, 0);
  std::set<double> costs;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const MotionPlan first = planMotion(q0, q1, problem, {.seed = seed});
    const MotionPlan other =
        planMotion(q1, q0, problem, {.seed = seed + 100});  // an earlier plan must not change the result
    const MotionPlan again = planMotion(q0, q1, problem, {.seed = seed});
    ASSERT_EQ(first.waypoints.size(), again.waypoints.size());
    for (std::size_t i = 0; i < first.waypoints.size(); ++i) EXPECT_EQ(first.waypoints[i], again.waypoints[i]);
    EXPECT_EQ(first.checks, again.checks);
    EXPECT_EQ(other.status, MotionPlanStatus::kFree);
    costs.insert(first.cost);
  }
  EXPECT_GT(costs.size(), 1u);  // different seeds lead to different searches
}

TEST(PlanMotion, SameWaypointsWhenThreadsPlanAtOnce) {
  const CollisionWorld world(kFourJoints.scene({{"post", shape("cylinder", {0.8, 0.05, -1, 0.8, 0.05, 1, 0.1}), {}}}));
  const auto problem = kFourJoints.problem(world, 2.6);
  const Vector4d q0(-0.7, 0.2, 0.1, 0), q1(0.7, -0.3, 0.2, 0);
  std::vector<MotionPlan> plans(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < plans.size(); ++i)
    threads.emplace_back([&, i] { plans[i] = planMotion(q0, q1, problem, {.seed = 1 + i % 4}); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < plans.size(); ++i)
    EXPECT_EQ(plans[i].waypoints, planMotion(q0, q1, problem, {.seed = 1 + i % 4}).waypoints);
}

}  // namespace
}  // namespace tubeplan::planner
