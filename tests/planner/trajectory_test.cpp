// The exported trajectory: constant acceleration between points, within limits, through every waypoint.
#include "planner/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

TEST(Trajectory, IsTheTimedPathItself) {
  const Workcell cell = testing::mockup();
  const VisitPlan plan = planVisits(cell, testing::tubesOf(cell, "spread:5"));
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned);
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  const auto points = trajectoryOf(plan, speeds);
  ASSERT_GT(points.size(), 2 * plan.segments.size());
  EXPECT_EQ(points.front().time, 0);
  EXPECT_NEAR(points.back().time, plan.total_time, 1e-9);
  EXPECT_EQ(points.front().position, plan.segments.front().waypoints.front());
  EXPECT_EQ(points.back().position, plan.segments.back().waypoints.back());
  EXPECT_TRUE(points.front().speed.isZero() && points.back().speed.isZero() && points.back().acceleration.isZero());
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto &a = points[k], &b = points[k + 1];
    const double step = b.time - a.time;
    EXPECT_GE(step, 1e-6);
    EXPECT_LT((a.speed + step * a.acceleration - b.speed).cwiseAbs().maxCoeff(), 1e-6) << k;
    EXPECT_LT((a.position + step * a.speed + step * step / 2 * a.acceleration - b.position).cwiseAbs().maxCoeff(), 1e-6)
        << k;
    EXPECT_LE((a.speed.cwiseAbs().array() / speeds.max_speed.array()).maxCoeff(), 1 + 1e-9);
    EXPECT_LE((a.acceleration.cwiseAbs().array() / speeds.max_acceleration.array()).maxCoeff(), 1 + 1e-9);
  }
}

TEST(Trajectory, RestsAtEveryWaypoint) {
  VisitPlan plan;
  const auto at = [](double x, double y) { return Eigen::VectorXd(Eigen::Vector2d(x, y)); };
  plan.segments.push_back({SegmentKind::kTravel, 0, {at(0, 0), at(1, 0), at(1, 0), at(1, 2)}, 0, {}});
  plan.segments.push_back({SegmentKind::kApproach, 0, {at(1, 2), at(1, 2.1)}, 0, {}});
  const JointSpeeds speeds{Eigen::Vector2d(1, 1), Eigen::Vector2d(2, 2)};
  const auto points = trajectoryOf(plan, speeds);
  // Moves of 1 and 2 rad at 1 rad/s with ramps of 0.5 s take 1.5 s and 2.5 s; the move of 0.1 rad never cruises and
  // takes 2 sqrt(0.1 / 2) s.
  const double last = 2 * std::sqrt(0.05);
  const std::vector<double> times{0, 0.5, 1, 1.5, 2, 3.5, 4, 4 + last / 2, 4 + last};
  ASSERT_EQ(points.size(), times.size());
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(points[k].time, times[k], 1e-12) << k;
  for (const std::size_t stop : {0, 3, 6, 8}) EXPECT_TRUE(points[stop].speed.isZero()) << stop;
  EXPECT_NEAR(points[1].position[0], 0.25, 1e-12);
  EXPECT_NEAR(points[1].speed[0], 1, 1e-12);
  EXPECT_NEAR(points[2].acceleration[0], -2, 1e-12);
  EXPECT_NEAR(points[3].acceleration[1], 2, 1e-12);
}

TEST(Trajectory, OfNothingIsNothing) { EXPECT_TRUE(trajectoryOf({}, {}).empty()); }

}  // namespace
}  // namespace tubeplan::planner
