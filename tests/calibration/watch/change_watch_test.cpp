// Watch over simulated visits: false alarms, and the delay and the kind of an alarm after a hidden step of the base or
// of a stiffness.
#include "calibration/watch/change_watch.hpp"

#include <gtest/gtest.h>

#include "tests/calibration/watch/simulated_outage.hpp"

namespace tubeplan::calibration {
namespace {

constexpr int kVisits = 120;

TEST(ChangeWatch, IsQuietWhereNothingChanges) {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulatedOutage outage(seed);
    const Watch watch = outage.watch(outage.visits(kVisits, kVisits, outage.truth(), outage.base()));
    EXPECT_TRUE(watch.status == WatchStatus::kQuiet || watch.status == WatchStatus::kAlarm) << watch.reason;
    alarms += watch.status == WatchStatus::kAlarm;
  }
  EXPECT_LE(alarms, 4);  // at most 1 in 20 is allowed; 5 of 40 have a probability below 0.05
}

TEST(ChangeWatch, FindsAStepOfTheBaseWithinAFewTouchesAndSaysSo) {
  int found = 0, as_base = 0, early = 0, delay = 0, begin = 0;
  constexpr int kOutages = 40;
  for (std::uint64_t seed = 101; seed < 101 + kOutages; ++seed) {
    SimulatedOutage outage(seed);
    const int since = 20 + outage.random().index(60);
    const Eigen::Vector3d way = outage.random().vector(1).normalized();
    Eigen::Isometry3d moved = outage.base();
    moved.translation() += 0.02 * kInch * way;
    const Watch watch = outage.watch(outage.visits(kVisits, since, outage.truth(), moved));
    if (!watch.alarm) continue;
    if (watch.alarm->measurement < since) {
      ++early;
      continue;
    }
    ++found;
    delay += watch.alarm->measurement - since + 1;
    as_base += watch.alarm->kind == ChangeKind::kBaseStep;
    begin += std::abs(watch.alarm->since - since) <= 2;
    for (int axis = 0; axis < 3; ++axis)
      if (watch.alarm->kind == ChangeKind::kBaseStep) {
        EXPECT_NEAR(watch.alarm->step[axis], 0.02 * kInch * way[axis], 5 * watch.alarm->step_sigma[axis]);
      }
  }
  EXPECT_GE(found, 0.95 * kOutages);
  EXPECT_LE(early, 2);
  EXPECT_GE(as_base, 0.9 * found);
  EXPECT_GE(begin, 0.7 * found);
  EXPECT_LE(delay, 12 * found);
}

TEST(ChangeWatch, AChangeOfTheArmIsNotCalledAStepOfTheBase) {
  int found = 0, as_base = 0;
  for (std::uint64_t seed = 201; seed <= 220; ++seed) {
    SimulatedOutage outage(seed);
    deflection::Arm changed = outage.truth();
    for (auto& row : changed.rows)
      if (row.name == "forearm") row.joint.offset += 0.15 * kDegree;  // a joint that has slipped
    const Watch watch = outage.watch(outage.visits(kVisits, 40, changed, outage.base()));
    found += watch.status == WatchStatus::kAlarm && watch.alarm->measurement >= 40;
    as_base += watch.alarm && watch.alarm->kind == ChangeKind::kBaseStep;
  }
  EXPECT_GE(found, 19);
  EXPECT_LE(as_base, 2);
}

TEST(ChangeWatch, OfNothingIsNotComputed) {
  SimulatedOutage outage(1);
  EXPECT_EQ(outage.watch({}).status, WatchStatus::kNotComputed);
}

}  // namespace
}  // namespace tubeplan::calibration
