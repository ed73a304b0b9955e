#include "planner/order/exact_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planner/order/branch_choice.hpp"
#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

/// Returns the shortest time [s] of all orders that respect the zones, each order with its best postures.
double quickestOfAll(const Route& route, const std::vector<int>& zones) {
  std::vector<int> order(route.visits.size());
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    const auto zoneOf = [&](int visit) { return zones.empty() ? 0 : zones[static_cast<std::size_t>(visit)]; };
    if (std::ranges::is_sorted(order, {}, zoneOf)) least = std::min(least, bestBranches(route, order).travel_time);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(ExactOrder, IsTheQuickestOfAllOrdersWithOrWithoutZonesAndEnds) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    std::mt19937_64 random(seed);
    const int visits = 1 + static_cast<int>(seed % 6);
    const Route route = randomRoute(random, visits, 4, seed % 2 == 0, seed % 3 == 0);
    const PostureTable table(route);
    std::vector<int> zones;
    for (int v = 0; v < visits && seed % 4 > 1; ++v) zones.push_back(static_cast<int>(random() % 3));
    const ExactOrder exact = exactOrder(table, straightTimes(table), zones);
    EXPECT_NEAR(exact.time, quickestOfAll(route, zones), 1e-9) << "seed " << seed;
    double time = 0;
    for (std::size_t k = 1; k < exact.postures.size(); ++k)
      time += table.straight(exact.postures[k - 1], exact.postures[k]);
    EXPECT_NEAR(exact.time, time, 1e-9);
    EXPECT_EQ(static_cast<int>(exact.postures.size()), table.nodes());
  }
}

TEST(ExactOrder, OfNoVisitsGoesFromTheStartToTheEnd) {
  std::mt19937_64 random(1);
  const Route route = randomRoute(random, 0, 1, true, true);
  const PostureTable table(route);
  const ExactOrder exact = exactOrder(table, straightTimes(table));
  EXPECT_EQ(exact.postures, (std::vector<int>{0, 1}));
  EXPECT_EQ(exact.time, moveDuration(*route.start, *route.end, route.speeds));
}

TEST(ExactOrder, IsForFewVisitsOrFewPostures) {
  std::mt19937_64 random(1);
  EXPECT_TRUE(isForExactOrder(PostureTable(randomRoute(random, 7, 40, true, true))));
  EXPECT_TRUE(isForExactOrder(PostureTable(randomRoute(random, 14, 1, false, false))));
  EXPECT_FALSE(isForExactOrder(PostureTable(randomRoute(random, 20, 1, false, false))));
  EXPECT_FALSE(isForExactOrder(PostureTable(randomRoute(random, 60, 1, false, false))));
}

}  // namespace
}  // namespace tubeplan::planner
