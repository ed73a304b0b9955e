#include "planner/motion/roadmap.hpp"

#include <gtest/gtest.h>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector2d, Eigen::VectorXd;
using testing::kTwoJoints;
using testing::leastSampled;
using testing::shape;

MotionProblem timed(MotionProblem problem) {
  problem.speeds = JointSpeeds{VectorXd::Constant(2, 0.5), VectorXd::Constant(2, 1)};
  problem.cost = [speeds = *problem.speeds](const VectorXd& a, const VectorXd& b) {
    return straightMoveDuration(a, b, speeds);
  };
  return problem;
}

RoadmapOptions small() {
  RoadmapOptions options;
  options.random_postures = 300;
  return options;
}

TEST(Roadmap, EveryStretchOfAWayIsFree) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  const auto problem = timed(kTwoJoints.problem(world));
  const Roadmap roadmap(problem, {Vector2d(-0.6, 0)}, small());
  EXPECT_EQ(roadmap.postures(), 301);
  EXPECT_GT(roadmap.edges(), 600);
  long checks = 0;
  const auto way = roadmap.between(Vector2d(-0.6, 0), Vector2d(0.6, 0), checks);
  ASSERT_EQ(way.status, RoadmapStatus::kFound);
  EXPECT_EQ(way.waypoints.front(), Vector2d(-0.6, 0));
  EXPECT_EQ(way.waypoints.back(), Vector2d(0.6, 0));
  EXPECT_GT(checks, 0);
  for (std::size_t k = 1; k < way.waypoints.size(); ++k)
    EXPECT_GE(leastSampled(way.waypoints[k - 1], way.waypoints[k], problem.clearance_of, 500), 0);
}

TEST(Roadmap, TheSameAnswerWhateverWasAskedBefore) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  const auto problem = timed(kTwoJoints.problem(world));
  const Roadmap one(problem, {}, small()), other(problem, {}, small());
  long checks = 0;
  (void)one.between(Vector2d(1, 1), Vector2d(-2, 1), checks);
  EXPECT_EQ(one.between(Vector2d(-0.6, 0), Vector2d(0.6, 0), checks).waypoints,
            other.between(Vector2d(-0.6, 0), Vector2d(0.6, 0), checks).waypoints);
}

TEST(Roadmap, PartsThatNothingJoinsAreToldApart) {
  // A wall extends outwards from the base over the length of the arm, so the first joint cannot pass it.
  const CollisionWorld world(kTwoJoints.scene({{"wall", shape("box", {0.8, 0, 0, 1.2, 0.02, 2, 0, 0, 0}), {}}}));
  auto problem = timed(kTwoJoints.problem(world, 1.4));
  const Roadmap roadmap(problem, {}, small());
  long checks = 0;
  EXPECT_EQ(roadmap.between(Vector2d(-0.8, 0), Vector2d(0.8, 0), checks).status, RoadmapStatus::kDisconnected);
  problem.roadmap = [&](const VectorXd& a, const VectorXd& b, long& checked) { return roadmap.between(a, b, checked); };
  const auto plan = planMotion(Vector2d(-0.8, 0), Vector2d(0.8, 0), problem);
  EXPECT_EQ(plan.status, MotionPlanStatus::kNoPath);
  EXPECT_EQ(plan.iterations, 0);
  EXPECT_NE(plan.reason.find("disconnected parts"), std::string::npos) << plan.reason;
}

TEST(Roadmap, AnEndThatIsShutInIsNotAttached) {
  const CollisionWorld world(kTwoJoints.scene({{"post", shape("cylinder", {0.9, 0, -1, 0.9, 0, 1, 0.1}), {}}}));
  auto problem = timed(kTwoJoints.problem(world));
  RoadmapOptions options = small();
  options.random_postures = 0;
  const Roadmap roadmap(problem, {Vector2d(0, 0)}, options);  // this posture collides, so the roadmap omits it
  EXPECT_EQ(roadmap.postures(), 0);
  long checks = 0;
  EXPECT_EQ(roadmap.between(Vector2d(-0.6, 0), Vector2d(0.6, 0), checks).status, RoadmapStatus::kUnattached);
}

}  // namespace
}  // namespace tubeplan::planner
