#include "planner/timing/flowing_timing.hpp"

#include <gtest/gtest.h>

#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::VectorXd;

const JointSpeeds kUneven{Eigen::Vector3d(1, 0.5, 2), Eigen::Vector3d(2, 4, 1)};

std::vector<VectorXd> randomWaypoints(std::mt19937_64& random, int count) {
  std::vector<VectorXd> waypoints;
  for (int k = 0; k < count; ++k) waypoints.push_back(postureWithinOne(random, 3));
  return waypoints;
}

double distanceToSegment(const VectorXd& p, const VectorXd& a, const VectorXd& b) {
  const VectorXd way = b - a;
  const double s = std::clamp((p - a).dot(way) / way.squaredNorm(), 0., 1.);
  return (p - a - s * way).norm();
}

TEST(TimeFlow, ASingleMoveIsTheStraightOne) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100; ++k) {
    const auto ends = randomWaypoints(random, 2);
    EXPECT_NEAR(timeFlow(ends, kUneven).duration, straightMoveDuration(ends[0], ends[1], kUneven), 1e-12);
  }
}

TEST(TimeFlow, AWaypointOnTheStraightLineCostsNothingWithAFullCruise) {
  const VectorXd a = Eigen::Vector3d(0, 0, 0), b = Eigen::Vector3d(4, 1, 2);
  const double straight = straightMoveDuration(a, b, kUneven);
  EXPECT_NEAR(timeFlow({a, 0.5 * (a + b), b}, kUneven).duration, straight, 1e-9);
  EXPECT_GT(timePolyline({a, 0.5 * (a + b), b}, kUneven).duration, straight + 0.1);
}

TEST(TimeFlow, KeepsLimitsJoinsUpAndArrives) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 300; ++k) {
    const auto waypoints = randomWaypoints(random, 2 + k % 5);
    const TimedFlow flow = timeFlow(waypoints, kUneven);
    ASSERT_FALSE(flow.phases.empty());
    EXPECT_EQ(flow.phases.front().from, waypoints.front());
    EXPECT_TRUE(flow.phases.front().speed.isZero(0));
    EXPECT_EQ(flow.end, waypoints.back());
    VectorXd at = flow.phases.front().from, speed = flow.phases.front().speed;
    double time = 0;
    for (const auto& phase : flow.phases) {
      EXPECT_NEAR(phase.start, time, 1e-12);
      EXPECT_LT((phase.from - at).norm(), 1e-12);
      EXPECT_LT((phase.speed - speed).norm(), 1e-12);
      at = phase.at(phase.duration);
      speed = phase.speed + phase.duration * phase.acceleration;
      time += phase.duration;
      EXPECT_TRUE((phase.acceleration.array().abs() <= kUneven.max_acceleration.array() * (1 + 1e-12)).all());
      EXPECT_TRUE((phase.speed.array().abs() <= kUneven.max_speed.array() * (1 + 1e-12)).all());
    }
    EXPECT_NEAR(flow.duration, time, 1e-12);
    EXPECT_LT((at - waypoints.back()).norm(), 1e-12);
    EXPECT_LT(speed.norm(), 1e-12);
  }
}

TEST(TimeFlow, CutsCornersWithinTheirTrianglesAndNeverBeatsTheLeastTime) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 100; ++k) {
    const auto waypoints = randomWaypoints(random, 3);
    const TimedFlow flow = timeFlow(waypoints, kUneven);
    EXPECT_GE(flow.duration, moveDuration(waypoints[0], waypoints[2], kUneven) - 1e-12);
    for (const auto& sample : sampleFlow(flow, 0.01)) {
      const double off = std::min(distanceToSegment(sample.posture, waypoints[0], waypoints[1]),
                                  distanceToSegment(sample.posture, waypoints[1], waypoints[2]));
      EXPECT_LE(off,
                0.25 * std::min((waypoints[1] - waypoints[0]).norm(), (waypoints[2] - waypoints[1]).norm()) + 1e-9);
    }
  }
}

TEST(TimeFlow, TheWayBackTakesAsLong) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 100; ++k) {
    auto waypoints = randomWaypoints(random, 4);
    const double forth = timeFlow(waypoints, kUneven).duration;
    std::ranges::reverse(waypoints);
    EXPECT_NEAR(timeFlow(waypoints, kUneven).duration, forth, 1e-9);
  }
}

TEST(TimeFlow, WaypointsWithoutLengthAndJointsWithoutInertia) {
  const VectorXd a = Eigen::Vector3d(0, 0, 0), b = Eigen::Vector3d(1, 0, 0), c = Eigen::Vector3d(1, 1, 0);
  EXPECT_TRUE(timeFlow({a, a, a}, kUneven).phases.empty());
  EXPECT_EQ(timeFlow({a, a}, kUneven).duration, 0);
  EXPECT_NEAR(timeFlow({a, b, b, c}, kUneven).duration, timeFlow({a, b, c}, kUneven).duration, 1e-12);
  const JointSpeeds sudden{Eigen::Vector3d(1, 1, 1),
                           Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity())};
  EXPECT_NEAR(timeFlow({a, b, c}, sudden).duration, 2, 1e-12);
}

TEST(SampleFlow, RowsLieOnTheCornersPolylineWhateverTheStep) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 50; ++k) {
    const TimedFlow flow = timeFlow(randomWaypoints(random, 4), kUneven);
    const auto corners = cornersOf(flow);
    const auto rows = sampleFlow(flow, 0.02);
    std::size_t leg = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r > 0) {
        EXPECT_GT(rows[r].time, rows[r - 1].time);
      }
      while (leg + 2 < corners.size() && distanceToSegment(rows[r].posture, corners[leg], corners[leg + 1]) > 1e-12)
        ++leg;
      EXPECT_LT(distanceToSegment(rows[r].posture, corners[leg], corners[leg + 1]), 1e-12);
    }
    EXPECT_EQ(leg + 2, corners.size());
    EXPECT_EQ(rows.back().posture, flow.end);
  }
}

}  // namespace
}  // namespace tubeplan::planner
