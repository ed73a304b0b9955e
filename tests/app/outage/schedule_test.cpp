// Assignment of legs to arms: the least end by exhaustive search, and the bound that holds for any number of legs.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "app/outage/job_schedule.hpp"

namespace tubeplan::app {
namespace {

/// Returns the least end over all assignments of legs to arms.
double leastEnd(const std::vector<LegWork>& legs, int arms) {
  double least = 1e300;
  std::vector<int> arm(legs.size(), 0);
  while (true) {
    std::vector<double> loads(static_cast<std::size_t>(arms), 0);
    for (std::size_t k = 0; k < legs.size(); ++k) loads[static_cast<std::size_t>(arm[k])] += legs[k].duration;
    least = std::min(least, *std::ranges::max_element(loads));
    std::size_t k = 0;
    while (k < legs.size() && ++arm[k] == arms) arm[k++] = 0;
    if (k == legs.size()) return least;
  }
}

std::vector<LegWork> drawnLegs(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> hours(1, 40);
  std::vector<LegWork> legs(static_cast<std::size_t>(count));
  for (LegWork& leg : legs) leg.duration = hours(random);
  return legs;
}

TEST(Schedule, EndsAsEarlyAsAnyAssignment) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const int arms = 1 + trial % 4;
    const auto legs = drawnLegs(random, 1 + trial % 7);
    const Schedule schedule = scheduleLegs(legs, arms);
    EXPECT_EQ(schedule.status, ScheduleStatus::kOptimal);
    EXPECT_NEAR(schedule.end, leastEnd(legs, arms), 1e-9);
    EXPECT_DOUBLE_EQ(schedule.lower_bound, schedule.end);
  }
}

TEST(Schedule, NoArmIsInTwoLegsAtOnce) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const auto legs = drawnLegs(random, 12 + trial % 12);
    const Schedule schedule = scheduleLegs(legs, 3);
    ASSERT_EQ(schedule.legs.size(), legs.size());
    EXPECT_LE(schedule.end, 4. / 3 * schedule.lower_bound + 40);
    for (std::size_t k = 0; k < legs.size(); ++k) {
      EXPECT_NEAR(schedule.legs[k].end - schedule.legs[k].start, legs[k].duration, 1e-9);
      for (std::size_t m = 0; m < k; ++m)
        EXPECT_TRUE(schedule.legs[k].arm != schedule.legs[m].arm ||
                    schedule.legs[k].start >= schedule.legs[m].end - 1e-9 ||
                    schedule.legs[m].start >= schedule.legs[k].end - 1e-9);
    }
  }
}

/// Returns the least end over all orders in which the legs can be placed, each at the earliest time at which an arm and
/// its groups are free until its end. One of these schedules is optimal: none of its legs can begin earlier.
double leastEndWithExclusions(const std::vector<LegWork>& legs, int arms,
                              const std::vector<ExclusiveLegs>& exclusive_legs) {
  std::vector<int> order(legs.size());
  std::iota(order.begin(), order.end(), 0);
  double least = 1e300;
  do {
    std::vector<ScheduledLeg> placed;
    for (const int leg : order) {
      const double duration = legs[static_cast<std::size_t>(leg)].duration;
      const auto fits = [&](double start) {
        const auto overlaps = [&](const ScheduledLeg& other) {
          return other.start < start + duration && start < other.end;
        };
        for (const ExclusiveLegs& group : exclusive_legs)
          for (const ScheduledLeg& other : placed)
            if (std::ranges::count(group, leg) > 0 && std::ranges::count(group, other.leg) > 0 && overlaps(other))
              return false;
        for (const ScheduledLeg& at : placed) {  // the number of busy arms changes only where a leg begins
          const double moment = std::max(at.start, start);
          const auto isBusy = [&](const ScheduledLeg& other) { return other.start <= moment && moment < other.end; };
          if (overlaps(at) && std::ranges::count_if(placed, isBusy) >= arms) return false;
        }
        return true;
      };
      double start = fits(0) ? 0 : 1e300;
      for (const ScheduledLeg& other : placed)
        if (other.end < start && fits(other.end)) start = other.end;
      ScheduledLeg& now = placed.emplace_back();
      now.leg = leg;
      now.start = start;
      now.end = start + duration;
    }
    least = std::min(least, std::ranges::max(placed, {}, &ScheduledLeg::end).end);
  } while (std::ranges::next_permutation(order).found);
  return least;
}

/// Returns a few groups of two or three legs.
std::vector<ExclusiveLegs> drawnGroups(std::mt19937_64& random, int count) {
  std::vector<ExclusiveLegs> exclusive_legs;
  for (int k = 0; k < count / 2; ++k) {
    ExclusiveLegs group;
    for (int leg = 0; leg < count; ++leg)
      if (random() % 3 == 0 && group.size() < 3) group.push_back(leg);
    if (group.size() > 1) exclusive_legs.push_back(group);
  }
  return exclusive_legs;
}

/// Expects that arms and groups have one leg at a time, and that each leg begins at once or when the one that it waits
/// for ends.
void expectExclusive(const Schedule& schedule, const std::vector<LegWork>& legs,
                     const std::vector<ExclusiveLegs>& exclusive_legs) {
  const auto areExclusive = [&](int one, int other) {
    return std::ranges::any_of(exclusive_legs, [&](const ExclusiveLegs& group) {
      return std::ranges::count(group, one) > 0 && std::ranges::count(group, other) > 0;
    });
  };
  ASSERT_EQ(schedule.legs.size(), legs.size());
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const ScheduledLeg& leg = schedule.legs[k];
    EXPECT_EQ(leg.leg, static_cast<int>(k));
    EXPECT_DOUBLE_EQ(leg.end, leg.start + legs[k].duration);
    for (const ScheduledLeg& other : schedule.legs)
      EXPECT_TRUE(other.leg == leg.leg || (other.arm != leg.arm && !areExclusive(other.leg, leg.leg)) ||
                  other.end <= leg.start || leg.end <= other.start);
    if (leg.start == 0) {
      EXPECT_EQ(leg.wait, WaitReason::kNone);
      continue;
    }
    ASSERT_NE(leg.wait, WaitReason::kNone);
    const ScheduledLeg& other = schedule.legs[static_cast<std::size_t>(leg.waits_for)];
    EXPECT_EQ(other.end, leg.start);
    EXPECT_TRUE(leg.wait == WaitReason::kArm ? other.arm == leg.arm && leg.idle == 0
                                             : areExclusive(leg.leg, other.leg));
  }
}

TEST(Schedule, OfLegsThatAreApartEndsAsEarlyAsAnyOrder) {
  std::mt19937_64 random(3);
  int later = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const int count = 2 + trial % 5, arms = 1 + trial % 3;
    const auto legs = drawnLegs(random, count);
    const auto exclusive_legs = drawnGroups(random, count);
    const Schedule schedule = scheduleLegs(legs, arms, exclusive_legs);
    EXPECT_EQ(schedule.status, ScheduleStatus::kOptimal);
    EXPECT_NEAR(schedule.end, leastEndWithExclusions(legs, arms, exclusive_legs), 1e-9);
    EXPECT_DOUBLE_EQ(schedule.lower_bound, schedule.end);
    expectExclusive(schedule, legs, exclusive_legs);
    later += schedule.end > scheduleLegs(legs, arms).end + 1e-9;
  }
  EXPECT_GT(later, 20);  // the groups matter
}

TEST(Schedule, OfManyLegsThatAreApartHoldsItsBound) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const auto legs = drawnLegs(random, 13 + trial);
    const auto exclusive_legs = drawnGroups(random, 13 + trial);
    const Schedule schedule = scheduleLegs(legs, 3, exclusive_legs);
    EXPECT_LE(schedule.lower_bound, schedule.end);
    EXPECT_EQ(schedule.status == ScheduleStatus::kOptimal, schedule.end == schedule.lower_bound);
    expectExclusive(schedule, legs, exclusive_legs);
  }
}

TEST(Schedule, TwoArmsForTheLegsOfOneGeneratorThatAreApart) {
  const Schedule schedule = scheduleLegs({{5}, {3}}, 2, {{0, 1}});
  EXPECT_EQ(schedule.end, 8);
  EXPECT_EQ(schedule.lower_bound, 8);
  const ScheduledLeg& second = schedule.legs[schedule.legs[0].start > 0 ? 0 : 1];
  EXPECT_NE(second.wait, WaitReason::kNone);
}

TEST(Schedule, OfNothingEndsAtOnce) { EXPECT_EQ(scheduleLegs({}, 2).end, 0); }

}  // namespace
}  // namespace tubeplan::app
