#include "planner/timing/trapezoid_timing.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/planner/random_draws.hpp"

namespace tubeplan::planner {
namespace {

using testing::randomPosture, testing::uniform;

// Expects speeds and accelerations within the limits: mean speeds along chords, and mean accelerations between the
// midpoints of neighbouring chords.
void expectWithinLimits(const std::vector<TimedPosture>& samples, const JointSpeeds& speeds) {
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double step = samples[k].time - samples[k - 1].time;
    const Eigen::ArrayXd speed = (samples[k].posture - samples[k - 1].posture).array() / step;
    ASSERT_TRUE((speed.abs() <= speeds.max_speed.array() + 1e-9).all()) << "sample " << k << ": " << speed.transpose();
    if (k < 2) continue;
    const double step_before = samples[k - 1].time - samples[k - 2].time;
    const Eigen::ArrayXd speed_before = (samples[k - 1].posture - samples[k - 2].posture).array() / step_before;
    const Eigen::ArrayXd acceleration = (speed - speed_before) / (0.5 * (step + step_before));
    ASSERT_TRUE((acceleration.abs() <= speeds.max_acceleration.array() + 1e-9).all())
        << "sample " << k << ": " << acceleration.transpose();
  }
}

TEST(TimeMove, TriangleHasNoCruise) {
  const JointSpeeds speeds{Eigen::VectorXd::Constant(1, 2), Eigen::VectorXd::Constant(1, 4)};
  const TimedMove move = timeMove(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.25), speeds);
  EXPECT_DOUBLE_EQ(move.duration, 0.5);
  EXPECT_EQ(move.cruise_time, 0);
  EXPECT_DOUBLE_EQ(sampleMove(move, 0.125)[0], 0.5 * 4 * 0.125 * 0.125);
  EXPECT_DOUBLE_EQ(sampleMove(move, 0.25)[0], 0.125);
}

TEST(TimeMove, TrapezoidRampsAndCruises) {
  const JointSpeeds speeds{Eigen::VectorXd::Constant(1, 2), Eigen::VectorXd::Constant(1, 4)};
  const TimedMove move = timeMove(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, -5), speeds);
  EXPECT_DOUBLE_EQ(move.duration, 3);
  EXPECT_DOUBLE_EQ(move.ramp_time, 0.5);
  EXPECT_DOUBLE_EQ(move.cruise_time, 2);
  EXPECT_DOUBLE_EQ(move.peak_speed * 5, 2);
  EXPECT_DOUBLE_EQ(sampleMove(move, 0.5)[0], -0.5);
  EXPECT_DOUBLE_EQ(sampleMove(move, 1.5)[0], -2.5);
  EXPECT_DOUBLE_EQ(sampleMove(move, 2.75)[0], -5 + 0.5 * 4 * 0.25 * 0.25);
}

TEST(TimeMove, InfiniteAccelerationGoesEvenly) {
  const JointSpeeds speeds{Eigen::VectorXd::Constant(1, 2), Eigen::VectorXd::Constant(1, testing::kInfinity)};
  const TimedMove move = timeMove(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 3), speeds);
  EXPECT_DOUBLE_EQ(move.duration, 1.5);
  for (const double time : {0.0, 0.1, 0.75, 1.4, 1.5}) EXPECT_NEAR(sampleMove(move, time)[0], 2 * time, 1e-15);
}

TEST(TimeMove, NoMoveStaysWhereItIs) {
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(3, 0.7);
  const TimedMove move = timeMove(q, q, {Eigen::VectorXd::Ones(3), Eigen::VectorXd::Ones(3)});
  EXPECT_EQ(move.duration, 0);
  EXPECT_EQ(sampleMove(move, 0.0), q);
  EXPECT_EQ(sampleMove(move, 1.0), q);
}

TEST(TimeMove, LastsAsLongAsTheStraightMove) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const JointSpeeds speeds{randomPosture(random, 4, 0.05, 2), randomPosture(random, 4, 0.05, 4)};
    const Eigen::VectorXd a = randomPosture(random, 4, -3, 3), b = randomPosture(random, 4, -3, 3);
    EXPECT_NEAR(timeMove(a, b, speeds).duration, straightMoveDuration(a, b, speeds), 1e-12);
  }
}

TEST(TimeMove, SomeLimitIsAlwaysReached) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const JointSpeeds speeds{randomPosture(random, 4, 0.05, 2), randomPosture(random, 4, 0.05, 4)};
    const Eigen::VectorXd a = randomPosture(random, 4, -3, 3), b = randomPosture(random, 4, -3, 3);
    const TimedMove move = timeMove(a, b, speeds);
    const Eigen::ArrayXd distance = (b - a).array().abs();
    EXPECT_NEAR((distance * move.peak_speed / move.ramp_time / speeds.max_acceleration.array()).maxCoeff(), 1, 1e-12);
    const double speed_share = (distance * move.peak_speed / speeds.max_speed.array()).maxCoeff();
    EXPECT_LE(speed_share, 1 + 1e-12);
    if (move.cruise_time > 0) {
      EXPECT_NEAR(speed_share, 1, 1e-12);
    }
  }
}

class RandomMoves : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomMoves, StayWithinTheLimitsOnTheStraightLine) {
  std::mt19937_64 random(GetParam());
  for (int i = 0; i < 800; ++i) {
    const JointSpeeds speeds{randomPosture(random, 4, 0.05, 2), randomPosture(random, 4, 0.05, 4)};
    const double reach = i % 3 == 0 ? 0.02 : 3;  // short moves without a cruise phase as well as long ones
    const Eigen::VectorXd a = randomPosture(random, 4, -reach, reach), b = randomPosture(random, 4, -reach, reach);
    const TimedPolyline line = timePolyline({a, b}, speeds);
    const std::vector<TimedPosture> samples = samplePolyline(line, line.duration / 97);
    expectWithinLimits(samples, speeds);
    const Eigen::VectorXd along = (b - a) / (b - a).squaredNorm();
    double progress_before = 0;
    for (const TimedPosture& sample : samples) {
      const double progress = along.dot(sample.posture - a);
      ASSERT_LE((sample.posture - a - progress * (b - a)).cwiseAbs().maxCoeff(), 1e-14);
      ASSERT_GE(progress, progress_before - 1e-15);
      progress_before = progress;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMoves, ::testing::Values(1, 2, 3, 4, 5));

TEST(TimePolyline, RestsAtEveryWaypointAndKeepsTheLimits) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 100; ++i) {
    const JointSpeeds speeds{randomPosture(random, 3, 0.2, 2), randomPosture(random, 3, 0.2, 4)};
    std::vector<Eigen::VectorXd> waypoints;
    for (int k = 0; k < 6; ++k) waypoints.push_back(randomPosture(random, 3, -2, 2));
    const TimedPolyline line = timePolyline(waypoints, speeds);
    const std::vector<TimedPosture> samples = samplePolyline(line, 0.02);
    double sum = 0;
    for (std::size_t k = 1; k < waypoints.size(); ++k)
      sum += straightMoveDuration(waypoints[k - 1], waypoints[k], speeds);
    EXPECT_NEAR(line.duration, sum, 1e-12);
    expectWithinLimits(samples, speeds);
    std::size_t met = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (met < waypoints.size() && samples[k].posture == waypoints[met]) ++met;  // counts exact hits, in order
      if (k == 0) continue;
      EXPECT_GT(samples[k].time, samples[k - 1].time);
      EXPECT_LE(samples[k].time - samples[k - 1].time, 0.02 * (1 + 1e-9));
    }
    EXPECT_EQ(met, waypoints.size());
    EXPECT_EQ(samples.front().posture, waypoints.front());
    EXPECT_EQ(samples.back().posture, waypoints.back());
    EXPECT_DOUBLE_EQ(samples.back().time, line.duration);
    EXPECT_EQ(samples.back().move, 4);
  }
}

TEST(TimePolyline, WaypointsThatRepeatAddNoSample) {
  const Eigen::VectorXd a = Eigen::VectorXd::Zero(2), b = Eigen::VectorXd::Ones(2);
  const JointSpeeds speeds{Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(2)};
  const auto once = samplePolyline(timePolyline({a, b}, speeds), 0.1),
             twice = samplePolyline(timePolyline({a, a, b, b}, speeds), 0.1);
  ASSERT_EQ(once.size(), twice.size());
  EXPECT_EQ(twice.back().move, 1);
  EXPECT_TRUE(samplePolyline(timePolyline({a}, speeds), 0.1).empty());
  EXPECT_EQ(samplePolyline(timePolyline({a, a}, speeds), 0.1).size(), 1U);
}

}  // namespace
}  // namespace tubeplan::planner
