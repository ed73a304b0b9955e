#include "planner/order/posture_table.hpp"

#include <gtest/gtest.h>

#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

/// Returns extra times for some moves between visits with an index divisible by three, and for one move from the start.
EdgePenalties somePenalties(const Route& route, std::mt19937_64& random) {
  EdgePenalties penalties;
  const int visits = static_cast<int>(route.visits.size());
  for (int a = 0; a < visits; a += 3)
    for (int b = 0; b < a; b += 3)
      for (int k = 0; k < static_cast<int>(route.visits[static_cast<std::size_t>(a)].branches.size()); k += 2)
        penalties.set(a, k, b, 0, uniform(random, 0, 3));
  if (route.start) penalties.set(kStartPosture, 0, 0, 0, 2);
  return penalties;
}

void expectTimesOneByOne(const Route& route) {
  const PostureTable table(route);
  Eigen::ArrayXd times;
  for (int posture = 0; posture < table.postures(); ++posture)
    for (int node = 0; node < table.nodes(); ++node) {
      table.costsTo(node, posture, times);
      ASSERT_EQ(times.size(), table.last(node) - table.first(node));
      int nearest = table.first(node);
      for (int q = table.first(node); q < table.last(node); ++q) {
        EXPECT_EQ(times[q - table.first(node)], table.cost(posture, q)) << posture << " to " << q;
        if (table.cost(posture, q) < table.cost(posture, nearest)) nearest = q;
      }
      EXPECT_EQ(table.nearestPosture(posture, node), nearest);
    }
}

// Times to all postures of a node, computed together, must equal the times computed one by one bit for bit, whether or
// not all joints have the same ratio of speed to acceleration, and with or without extra times.
TEST(PostureTable, TimesOfAllPosturesOfANodeAreThoseOfEach) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    Route route = randomRoute(random, 10, 13, seed % 2 == 0, seed % 3 == 0);
    if (seed % 4 < 2) route.speeds = evenSpeeds(3);
    expectTimesOneByOne(route);
    const EdgePenalties penalties = somePenalties(route, random);
    route.extra_time = penalties;
    expectTimesOneByOne(route);
    for (int visit = 0; visit < 10; ++visit) route.with_extra.push_back(penalties.touches(visit));
    expectTimesOneByOne(route);
  }
}

// No extra times must be requested for visits that are declared to have none, and the times must stay the same.
TEST(PostureTable, AsksForExtraTimesOnlyWhereTheyMayBe) {
  std::mt19937_64 random(3);
  Route route = randomRoute(random, 10, 5, true, false);
  const EdgePenalties penalties = somePenalties(route, random);
  route.extra_time = penalties;
  const PostureTable full_table(route);
  std::vector<double> expected;
  for (int p = 0; p < full_table.postures(); ++p)
    for (int q = 0; q < full_table.postures(); ++q) expected.push_back(full_table.cost(p, q));
  for (int visit = 0; visit < 10; ++visit) route.with_extra.push_back(penalties.touches(visit));
  route.extra_time = [&](int a, int branch_a, int b, int branch_b) {
    EXPECT_TRUE(penalties.touches(a) || a < 0) << a;
    EXPECT_TRUE(penalties.touches(b) || b < 0) << b;
    return penalties(a, branch_a, b, branch_b);
  };
  const PostureTable table(route);
  for (int p = 0, k = 0; p < table.postures(); ++p)
    for (int q = 0; q < table.postures(); ++q) EXPECT_EQ(table.cost(p, q), expected[static_cast<std::size_t>(k++)]);
}

}  // namespace
}  // namespace tubeplan::planner
