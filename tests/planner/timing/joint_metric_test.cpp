#include "planner/timing/joint_metric.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/planner/random_draws.hpp"

namespace tubeplan::planner {
namespace {

using testing::randomPosture, testing::uniform;

Eigen::VectorXd vectorOf(std::initializer_list<double> values) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), vector.begin());
  return vector;
}

TEST(MoveDuration, TriangleOfOneJoint) {
  const JointSpeeds speeds{vectorOf({2}), vectorOf({4})};  // reaches full speed in moves of 1 rad or more
  EXPECT_DOUBLE_EQ(moveDuration(vectorOf({0}), vectorOf({0.25}), speeds), 2 * std::sqrt(0.25 / 4));
  EXPECT_DOUBLE_EQ(moveDuration(vectorOf({0.3}), vectorOf({-0.7}), speeds), 1.0);
}

TEST(MoveDuration, TrapezoidOfOneJoint) {
  const JointSpeeds speeds{vectorOf({2}), vectorOf({4})};
  EXPECT_DOUBLE_EQ(moveDuration(vectorOf({0}), vectorOf({5}), speeds), 5.0 / 2 + 2.0 / 4);
}

TEST(MoveDuration, InfiniteAccelerationIsDistanceOverSpeed) {
  const JointSpeeds speeds{vectorOf({2, 1}), vectorOf({testing::kInfinity, testing::kInfinity})};
  EXPECT_DOUBLE_EQ(moveDuration(vectorOf({0, 0}), vectorOf({3, 1}), speeds), 1.5);
  EXPECT_DOUBLE_EQ(straightMoveDuration(vectorOf({0, 0}), vectorOf({3, 1}), speeds), 1.5);
}

TEST(MoveDuration, NoMoveTakesNoTime) {
  const JointSpeeds speeds{vectorOf({2, 1}), vectorOf({3, testing::kInfinity})};
  EXPECT_EQ(moveDuration(vectorOf({1, 2}), vectorOf({1, 2}), speeds), 0);
  EXPECT_EQ(straightMoveDuration(vectorOf({1, 2}), vectorOf({1, 2}), speeds), 0);
}

TEST(MoveDuration, TheSlowestJointDecides) {
  const JointSpeeds speeds{vectorOf({1, 1, 0.1}), vectorOf({2, 2, 2})};
  EXPECT_DOUBLE_EQ(moveDuration(vectorOf({0, 0, 0}), vectorOf({1, -2, 0.5}), speeds), 0.5 / 0.1 + 0.1 / 2);
}

// One joint is limited by speed, the other by acceleration; on the straight move both limits apply to the common
// motion.
TEST(StraightMoveDuration, TakesTheWorstOfBothLimits) {
  const JointSpeeds speeds{vectorOf({1, 100}), vectorOf({100, 1})};
  const Eigen::VectorXd from = vectorOf({0, 0}), to = vectorOf({4, 4});
  EXPECT_DOUBLE_EQ(moveDuration(from, to, speeds), 4 + 0.01);
  EXPECT_DOUBLE_EQ(straightMoveDuration(from, to, speeds), 4 + 1.0);
}

TEST(StraightMoveDuration, NeverQuickerThanTheLeastAndEqualForOneRatio) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 1000; ++i) {
      const JointSpeeds mixed{randomPosture(random, 4, 0.05, 2), randomPosture(random, 4, 0.05, 4)};
      const JointSpeeds alike{mixed.max_speed, 3 * mixed.max_speed};
      const Eigen::VectorXd a = randomPosture(random, 4, -3, 3), b = randomPosture(random, 4, -3, 3);
      EXPECT_GE(straightMoveDuration(a, b, mixed), moveDuration(a, b, mixed) * (1 - 1e-14));
      EXPECT_NEAR(straightMoveDuration(a, b, alike), moveDuration(a, b, alike), 1e-12);
    }
  }
}

TEST(MoveDuration, IsSymmetricAndADetourNeverGains) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const JointSpeeds speeds{randomPosture(random, 3, 0.05, 2), randomPosture(random, 3, 0.05, 4)};
    const Eigen::VectorXd a = randomPosture(random, 3, -3, 3), b = randomPosture(random, 3, -3, 3),
                          c = randomPosture(random, 3, -3, 3);
    EXPECT_EQ(moveDuration(a, b, speeds), moveDuration(b, a, speeds));
    EXPECT_LE(moveDuration(a, c, speeds), moveDuration(a, b, speeds) + moveDuration(b, c, speeds) + 1e-12);
    EXPECT_LE(straightMoveDuration(a, c, speeds),
              straightMoveDuration(a, b, speeds) + straightMoveDuration(b, c, speeds) + 1e-12);
  }
}

TEST(FindSpeedProblems, NamesWhatIsWrong) {
  EXPECT_TRUE(findSpeedProblems({vectorOf({1, 2}), vectorOf({3, testing::kInfinity})}, 2).empty());
  EXPECT_EQ(findSpeedProblems({vectorOf({1, 2}), vectorOf({3, 4})}, 3).size(), 1U);
  EXPECT_EQ(findSpeedProblems({vectorOf({0, -1}), vectorOf({3, 4})}, 2).size(), 2U);
  EXPECT_EQ(findSpeedProblems({vectorOf({1}), vectorOf({std::nan("")})}, 1).size(), 1U);
  EXPECT_EQ(findSpeedProblems({vectorOf({testing::kInfinity}), vectorOf({testing::kInfinity})}, 1).size(), 1U);
}

}  // namespace
}  // namespace tubeplan::planner
