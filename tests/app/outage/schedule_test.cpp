// The shares of legs among arms: the least end by exhaustive search, and the bound that holds for any number of legs.
#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Schedule, OfNothingEndsAtOnce) { EXPECT_EQ(scheduleLegs({}, 2).end, 0); }

}  // namespace
}  // namespace tubeplan::app
