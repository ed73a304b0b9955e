// The order of an earlier plan, applied to a changed list of tubes.
#include "planner/order/kept_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planner/order/branch_choice.hpp"
#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

std::vector<int> countedFrom(int first, int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

TEST(KeptOrder, KeepsWhatStaysInItsOrderAndTakesInTheRest) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const Route route = randomRoute(random, 40, 3, false, false);
    const auto tubes = countedFrom(100, 40);
    std::vector<int> before = countedFrom(98, 40);  // two tubes were removed from the list and two were added
    std::shuffle(before.begin(), before.end(), random);
    std::vector<int> order = keptOrder(route, tubes, before);
    ASSERT_EQ(order.size(), 40u);
    std::vector<int> kept;
    for (const int visit : order)
      if (std::count(before.begin(), before.end(), 100 + visit)) kept.push_back(100 + visit);
    std::erase_if(before, [](int tube) { return tube < 100; });
    EXPECT_EQ(kept, before);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, countedFrom(0, 40));
  }
}

TEST(KeptOrder, OneNewTubeStandsWhereItCostsLeast) {
  // With one branch per visit the time of an order is the sum of the times of its moves, so the test can try every
  // position of the new tube.
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 20; ++trial) {
    const Route route = randomRoute(random, 30, 1, false, false);
    std::vector<int> before = countedFrom(0, 29);
    std::shuffle(before.begin(), before.end(), random);
    const auto order = keptOrder(route, countedFrom(0, 30), before);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t place = 0; place <= before.size(); ++place) {
      auto tried = before;
      tried.insert(tried.begin() + static_cast<std::ptrdiff_t>(place), 29);
      least = std::min(least, bestBranches(route, tried).travel_time);
    }
    EXPECT_NEAR(bestBranches(route, order).travel_time, least, 1e-9);
  }
}

TEST(KeptOrder, GivesWayToANewSearchWhereMuchIsAdded) {
  std::mt19937_64 random(2);
  const Route route = randomRoute(random, 40, 2, false, false);
  EXPECT_TRUE(keptOrder(route, countedFrom(0, 40), countedFrom(5, 40)).empty());
  EXPECT_FALSE(keptOrder(route, countedFrom(0, 40), countedFrom(4, 40)).empty());
  EXPECT_TRUE(keptOrder(route, countedFrom(0, 40), {}).empty());
}

TEST(KeptOrder, OfWhatIsLeftIsTheOldOrderHoweverMuchIsDone) {
  std::mt19937_64 random(4);
  const Route route = randomRoute(random, 10, 2, false, false);
  std::vector<int> before = countedFrom(0, 400);
  std::shuffle(before.begin(), before.end(), random);
  const std::vector<int> order = keptOrder(route, countedFrom(0, 10), before);
  std::erase_if(before, [](int tube) { return tube >= 10; });
  EXPECT_EQ(order, before);
}

TEST(KeptOrder, NewNeighboursAreCounted) {
  const auto tubes = countedFrom(100, 6);
  const std::vector<int> before{100, 101, 90, 102, 103, 91, 104};
  EXPECT_EQ(countNewNeighbours({0, 1, 2, 3, 4, 5}, tubes, before), 3);  // 101-102, 103-104 and 104-105
  EXPECT_EQ(countNewNeighbours({3, 2}, tubes, before), 0);              // the other way round
  EXPECT_EQ(countNewNeighbours({}, tubes, before), 0);
}

}  // namespace
}  // namespace tubeplan::planner
