#include "planner/order/zoned_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planner/visit_conditions.hpp"
#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

VisitOrderOptions withSeed(std::uint64_t seed) {
  VisitOrderOptions options;
  options.seed = seed;
  options.least_kicks = 2000;  // enough for these small problems
  return options;
}

std::vector<int> zonesByTurn(std::size_t visits, int count) {
  std::vector<int> zones(visits);
  for (std::size_t k = 0; k < visits; ++k) zones[k] = static_cast<int>(k) % count;
  return zones;
}

/// Returns the shortest time [s] over all branches and all orders that respect the zones.
double exhaustive(const Route& route, const std::vector<int>& zones) {
  std::vector<int> order(route.visits.size());
  std::iota(order.begin(), order.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    const bool keeps = std::is_sorted(order.begin(), order.end(), [&](int a, int b) { return zones[a] < zones[b]; });
    if (keeps) best = std::min(best, exhaustiveBranches(route, order));
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(OrderByZones, KeepsToTheZonesAndTellsItsTime) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20; ++k) {
    const Route route = randomRoute(random, 30, 3, k % 2 == 0, k % 3 == 0);
    const auto zones = zonesByTurn(30, 1 + k % 4);
    const VisitOrder order = orderByZones(route, zones, withSeed(7));
    ASSERT_EQ(order.status, VisitOrderStatus::kSolved) << order.reason;
    std::vector<int> sorted = order.order;
    std::ranges::sort(sorted);
    for (int v = 0; v < 30; ++v) EXPECT_EQ(sorted[static_cast<std::size_t>(v)], v);
    EXPECT_TRUE(std::ranges::is_sorted(order.order, {}, [&](int v) { return zones[static_cast<std::size_t>(v)]; }));
    EXPECT_NEAR(order.travel_time, timeOf(route, order.order, order.branches), 1e-9);
    EXPECT_LE(order.lower_bound, order.travel_time);
    EXPECT_GT(order.lower_bound, 0.3 * order.travel_time);
  }
}

TEST(OrderByZones, TheBoundHoldsForTheBestOrderOfAll) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 12; ++k) {
    const Route route = randomRoute(random, 6, 2, k % 2 == 0, k % 3 == 0);
    const auto zones = zonesByTurn(6, 2 + k % 2);
    const double best = exhaustive(route, zones);
    EXPECT_LE(zonedBound(route, zones), best + 1e-9);
    EXPECT_GE(orderByZones(route, zones, {}).travel_time, best - 1e-9);
  }
}

/// With one visit per zone, which fixes the order, the branches must be the best for the whole route.
TEST(OrderByZones, ChoosesBranchesOverAllZones) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 20; ++k) {
    const Route route = randomRoute(random, 7, 3, k % 2 == 0, k % 3 == 0);
    std::vector<int> zones(7);
    std::iota(zones.begin(), zones.end(), 0);
    const VisitOrder order = orderByZones(route, zones, {});
    EXPECT_NEAR(order.travel_time, exhaustiveBranches(route, zones), 1e-9);
    EXPECT_NEAR(order.travel_time, timeOf(route, order.order, order.branches), 1e-9);
  }
}

TEST(OrderByZones, OneZoneIsTheOrderWithoutZones) {
  std::mt19937_64 random(3);
  const Route route = randomRoute(random, 40, 2, true, false);
  const VisitOrder one = orderByZones(route, std::vector<int>(40, 0), withSeed(3)),
                   plain = orderVisits(route, withSeed(3));
  EXPECT_EQ(one.order, plain.order);
  EXPECT_EQ(one.branches, plain.branches);
  EXPECT_EQ(one.lower_bound, plain.lower_bound);
}

TEST(OrderByZones, ExtraTimesCountAcrossZonesToo) {
  std::mt19937_64 random(4);
  Route route = randomRoute(random, 8, 1, true, false);
  const auto zones = zonesByTurn(8, 2);
  const auto before = orderByZones(route, zones, {});
  // The moves from the start and from the first zone to the second become expensive; other moves remain cheap.
  const int last = before.order[3], next = before.order[4], first = before.order[0];
  EdgePenalties penalties;
  penalties.set(last, 0, next, 0, 100);
  penalties.set(kStartPosture, 0, first, 0, 100);
  route.extra_time = std::cref(penalties);
  const auto after = orderByZones(route, zones, {});
  EXPECT_LT(after.travel_time, 100);
  EXPECT_NEAR(after.travel_time, timeOf(route, after.order, after.branches), 1e-9);
}

TEST(RowByRow, GoesThroughEachZoneInItsTurn) {
  Route route = latticeRoute(3, 0.1, 1);
  const std::vector<int> rows{1, 1, 1, 2, 2, 2, 3, 3, 3}, columns{1, 2, 3, 1, 2, 3, 1, 2, 3};
  std::vector<int> zones(9, 0);
  EXPECT_NEAR(rowByRowTime(route, zones, rows, columns),
              timeOf(route, {0, 1, 2, 5, 4, 3, 6, 7, 8}, std::vector<int>(9, 0)), 1e-9);
  zones[0] = 1;
  EXPECT_NEAR(rowByRowTime(route, zones, rows, columns),
              timeOf(route, {1, 2, 5, 4, 3, 6, 7, 8, 0}, std::vector<int>(9, 0)), 1e-9);
}

TEST(RowByRow, IsUnknownWithoutARowColumnAndZoneForEachVisit) {
  const Route route = latticeRoute(3, 0.1, 1);
  EXPECT_TRUE(std::isnan(rowByRowTime(route, {0}, {1}, {1})));
  EXPECT_TRUE(std::isnan(rowByRowTime(route, std::vector<int>(9, 0), std::vector<int>(9, 1), {1})));
}

TEST(ZonesOf, ListedTubesComeFirstAndEmptyZonesDoNotCount) {
  VisitConditions conditions;
  conditions.zones = {{7, 8}, {99}, {3}};
  EXPECT_EQ(zonesOf({3, 5, 7, 8}, conditions), (std::vector<int>{1, 2, 0, 0}));
  EXPECT_EQ(zonesOf({5, 6}, conditions), (std::vector<int>{0, 0}));
  EXPECT_EQ(zonesOf({5, 6}, {}), (std::vector<int>{0, 0}));
}

}  // namespace
}  // namespace tubeplan::planner
