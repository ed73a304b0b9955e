#include "planner/order/visit_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "planner/order/branch_choice.hpp"
#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

// Returns the optimum over all orders and branches by dynamic programming over (set of visits, last posture) (Held and
// Karp 1962).
double optimum(const Route& route) {
  struct Posture {
    int visit, branch;
  };
  std::vector<Posture> postures;
  for (int v = 0; v < static_cast<int>(route.visits.size()); ++v) {
    for (int b = 0; b < static_cast<int>(route.visits[v].branches.size()); ++b) postures.push_back({v, b});
  }
  const std::size_t sets = std::size_t{1} << route.visits.size(), count = postures.size();
  const auto at = [&](const Posture& p) { return route.visits[p.visit].branches[p.branch]; };
  const auto extra = [&](const Posture& a, const Posture& b) {
    return route.extra_time ? route.extra_time(a.visit, a.branch, b.visit, b.branch) : 0.0;
  };
  std::vector<double> time(sets * count, std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < count; ++p) {
    const double first = route.start ? straightMoveDuration(*route.start, at(postures[p]), route.speeds) +
                                           extra({kStartPosture, 0}, postures[p])
                                     : 0;
    time[(std::size_t{1} << postures[p].visit) * count + p] = first;
  }
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t p = 0; p < count; ++p) {
      for (std::size_t q = 0; q < count; ++q) {
        const std::size_t bit = std::size_t{1} << postures[q].visit;
        if (set & bit) continue;
        double& shortest = time[(set | bit) * count + q];
        shortest = std::min(shortest, time[set * count + p] +
                                          straightMoveDuration(at(postures[p]), at(postures[q]), route.speeds) +
                                          extra(postures[p], postures[q]));
      }
    }
  }
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < count; ++p) {
    const double last = route.end ? straightMoveDuration(at(postures[p]), *route.end, route.speeds) +
                                        extra(postures[p], {kEndPosture, 0})
                                  : 0;
    best = std::min(best, time[(sets - 1) * count + p] + last);
  }
  return best;
}

void expectValid(const Route& route, const VisitOrder& result) {
  ASSERT_EQ(result.status, VisitOrderStatus::kSolved) << result.reason;
  std::vector<int> sorted = result.order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(route.visits.size());
  std::iota(all.begin(), all.end(), 0);
  ASSERT_EQ(sorted, all);
  ASSERT_EQ(result.branches.size(), all.size());
  EXPECT_NEAR(result.travel_time, timeOf(route, result.order, result.branches), 1e-9 * (1 + result.travel_time));
}

/// Returns options that select the heuristic search even for a few visits.
VisitOrderOptions quick(std::uint64_t seed) {
  VisitOrderOptions options;
  options.seed = seed;
  options.most_exact_work = 0;
  options.least_kicks = 3000;
  options.with_bound = false;
  return options;
}

TEST(OrderVisits, FindsTheOptimumOfSmallRoutes) {
  int found = 0, tried = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const auto& [start, end] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
      std::mt19937_64 random(seed * 100 + (start ? 10 : 0) + (end ? 1 : 0));
      const int visits = 5 + static_cast<int>(seed % 5);
      const Route route = randomRoute(random, visits, 3, start, end);
      const VisitOrder result = orderVisits(route, quick(seed));
      expectValid(route, result);
      const double best = optimum(route);
      EXPECT_GE(result.travel_time, best - 1e-9);
      EXPECT_LE(result.travel_time, 1.05 * best);
      found += result.travel_time <= best + 1e-9 ? 1 : 0;
      ++tried;
    }
  }
  EXPECT_GE(found, tried - 2) << "of " << tried;
}

TEST(OrderVisits, OrdersAFewVisitsExactlyWithABoundThatTheyReach) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    Route route = randomRoute(random, static_cast<int>(seed % 10), 3, seed % 2 == 0, seed % 3 == 0);
    const VisitOrder straight = orderVisits(route);
    expectValid(route, straight);
    if (route.visits.empty()) continue;
    EXPECT_NEAR(straight.travel_time, optimum(route), 1e-9);
    EXPECT_EQ(straight.optimality_gap, 0);
    EdgePenalties penalties;
    for (std::size_t k = 1; k < straight.order.size(); ++k)
      penalties.set(straight.order[k - 1], straight.branches[k - 1], straight.order[k], straight.branches[k], 0.3);
    route.extra_time = penalties;
    const VisitOrder round = orderVisits(route);
    expectValid(route, round);
    EXPECT_NEAR(round.travel_time, optimum(route), 1e-9);
    EXPECT_NEAR(round.lower_bound, straight.travel_time, 1e-9);
  }
}

TEST(OrderVisits, BeginsFromAGivenOrderAndOnlyGainsOnIt) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::mt19937_64 random(seed);
    const Route route = randomRoute(random, 60, 3, seed % 2 == 0, seed % 3 == 0);
    VisitOrderOptions options = quick(seed);
    const VisitOrder searched = orderVisits(route, options);
    options.start = searched.order;
    const VisitOrder again = orderVisits(route, options);
    expectValid(route, again);
    EXPECT_LE(again.travel_time, searched.travel_time + 1e-9);
    std::shuffle(options.start.begin(), options.start.end(), random);
    const VisitOrder repaired = orderVisits(route, options);
    expectValid(route, repaired);
    EXPECT_LT(repaired.travel_time, bestBranches(route, options.start).travel_time);
  }
}

TEST(OrderVisits, StoppedAtOnceStillGivesAWholeOrderAndABoundThatHolds) {
  std::mt19937_64 random(4);
  const Route route = randomRoute(random, 80, 2, false, false);
  const VisitOrder searched = orderVisits(route, quick(1));
  VisitOrderOptions options;
  std::atomic<int> calls = 0;
  options.stop = [&] { return ++calls > 0; };
  const VisitOrder stopped = orderVisits(route, options);
  expectValid(route, stopped);
  EXPECT_GT(calls, 0);
  EXPECT_LE(stopped.lower_bound, searched.travel_time);
}

TEST(OrderVisits, FindsTheOptimumWithExtraTimes) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    Route route = randomRoute(random, 7, 2, true, false);
    EdgePenalties penalties;
    for (int k = 0; k < 60; ++k) {
      const int a = static_cast<int>(random() % 7), b = static_cast<int>(random() % 7);
      if (a == b) continue;
      penalties.set(a, static_cast<int>(random() % route.visits[a].branches.size()), b,
                    static_cast<int>(random() % route.visits[b].branches.size()),
                    k % 3 == 0 ? 1e5 : uniform(random, 0, 2));
    }
    route.extra_time = penalties;
    const VisitOrder result = orderVisits(route, quick(seed));
    expectValid(route, result);
    found += result.travel_time <= optimum(route) + 1e-9 ? 1 : 0;
  }
  EXPECT_GE(found, 9);
}

TEST(OrderVisits, TriesEveryOrderOfAFewVisits) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const Route route = randomRoute(random, 1 + static_cast<int>(seed % 4), 4, seed % 2 == 0, seed % 3 == 0);
    const VisitOrder result = orderVisits(route);
    expectValid(route, result);
    EXPECT_NEAR(result.travel_time, optimum(route), 1e-9);
    EXPECT_LE(result.lower_bound, result.travel_time + 1e-9);
  }
}

class OrderSeeds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(OrderSeeds, EveryVisitOnceAndTheSameAgain) {
  std::mt19937_64 random(GetParam());
  for (const int visits : {5, 6, 17, 80}) {
    const Route route = randomRoute(random, visits, 4, random() % 2 == 0, random() % 2 == 0);
    const VisitOrder result = orderVisits(route, quick(GetParam())), again = orderVisits(route, quick(GetParam()));
    expectValid(route, result);
    EXPECT_EQ(result.order, again.order);
    EXPECT_EQ(result.branches, again.branches);
    EXPECT_EQ(result.travel_time, again.travel_time);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OrderSeeds, ::testing::Range<std::uint64_t>(1, 9));

TEST(OrderVisits, GapOfALatticeIsSmall) {
  const Route route = latticeRoute(20, 0.05, 1);
  VisitOrderOptions options;
  options.least_kicks = 10'000;
  const VisitOrder result = orderVisits(route, options);
  expectValid(route, result);
  EXPECT_GE(result.optimality_gap, 0);
  EXPECT_LT(result.optimality_gap, 0.02);
  EXPECT_NEAR(result.optimality_gap, result.travel_time / result.lower_bound - 1, 1e-12);
}

TEST(OrderVisits, GapOfALatticeWithBothElbowsIsSane) {
  const Route route = latticeRoute(20, 0.05, 2);
  VisitOrderOptions options;
  options.least_kicks = 10'000;
  const VisitOrder result = orderVisits(route, options);
  expectValid(route, result);
  EXPECT_GE(result.optimality_gap, 0);
  EXPECT_LT(result.optimality_gap, 0.06);
  EXPECT_LE(result.travel_time, orderVisits(latticeRoute(20, 0.05, 1), options).travel_time * 1.005);
}

TEST(OrderVisits, BeatsRowByRow) {
  const Route route = latticeRoute(12, 0.08, 2);
  std::vector<int> rows, columns;
  for (int i = 0; i < 144; ++i) {
    rows.push_back(i / 12);
    columns.push_back(i % 12);
  }
  EXPECT_LT(orderVisits(route, quick(1)).travel_time, bestBranches(route, serpentineOrder(rows, columns)).travel_time);
}

TEST(OrderVisits, KeepsClearOfAForbiddenCrossing) {
  Route route = latticeRoute(6, 0.1, 1);
  const auto side = [](int visit) { return visit >= 0 && visit % 6 >= 3; };
  // Only the move between visits 14 and 15 connects the two halves of the lattice, so the order crosses once.
  route.extra_time = [&](int a, int, int b, int) {
    if (a < 0 || b < 0 || side(a) == side(b) || (std::min(a, b) == 14 && std::max(a, b) == 15)) return 0.0;
    return std::numeric_limits<double>::infinity();
  };
  const VisitOrder result = orderVisits(route, quick(3));
  expectValid(route, result);
  int crossings = 0;
  for (std::size_t k = 1; k < result.order.size(); ++k) crossings += side(result.order[k - 1]) != side(result.order[k]);
  EXPECT_EQ(crossings, 1);
}

TEST(OrderVisits, SaysWhenNoOrderIsFree) {
  Route route = latticeRoute(3, 0.1, 1);
  route.extra_time = [](int a, int, int b, int) {
    return a == 4 || b == 4 ? std::numeric_limits<double>::infinity() : 0.0;
  };
  const VisitOrder result = orderVisits(route, quick(1));
  EXPECT_EQ(result.status, VisitOrderStatus::kForbiddenMove);
  EXPECT_EQ(result.order.size(), 9U);
  EXPECT_TRUE(std::isinf(result.travel_time));
  EXPECT_FALSE(result.reason.empty());
}

TEST(OrderVisits, VisitsAtOnePlaceCostNothing) {
  Route route;
  route.speeds = evenSpeeds(2);
  for (int i = 0; i < 12; ++i) route.visits.push_back({{Eigen::VectorXd::Constant(2, 0.3)}});
  const VisitOrder result = orderVisits(route, quick(1));
  expectValid(route, result);
  EXPECT_EQ(result.travel_time, 0);
}

TEST(OrderVisits, NothingToVisitIsTheMoveFromStartToEnd) {
  std::mt19937_64 random(2);
  const Route route = randomRoute(random, 0, 1, true, true);
  const VisitOrder result = orderVisits(route);
  EXPECT_EQ(result.status, VisitOrderStatus::kSolved);
  EXPECT_TRUE(result.order.empty());
  EXPECT_NEAR(result.travel_time, straightMoveDuration(*route.start, *route.end, route.speeds), 1e-12);
  EXPECT_EQ(orderVisits(Route{{}, evenSpeeds(2), {}, {}, {}, {}}).travel_time, 0);
}

TEST(OrderVisits, RefusesAVisitWithoutPosture) {
  Route route = latticeRoute(3, 0.1, 1);
  route.visits[7].branches.clear();
  const VisitOrder result = orderVisits(route);
  EXPECT_EQ(result.status, VisitOrderStatus::kBadInput);
  EXPECT_NE(result.reason.find("visit 7"), std::string::npos);
  EXPECT_TRUE(result.order.empty());
}

}  // namespace
}  // namespace tubeplan::planner
