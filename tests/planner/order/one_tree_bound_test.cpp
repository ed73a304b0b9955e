#include "planner/order/one_tree_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planner/order/branch_choice.hpp"
#include "planner/order/priced_tree.hpp"
#include "planner/order/visit_order.hpp"
#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

double optimum(const Route& route) {
  std::vector<int> order(route.visits.size());
  std::iota(order.begin(), order.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    best = std::min(best, bestBranches(route, order).travel_time);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

class BoundSeeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BoundSeeds, NeverAboveTheOptimum) {
  std::mt19937_64 random(GetParam());
  for (const auto& [start, end] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
    for (int visits = 1; visits <= 6; ++visits) {
      const Route route = randomRoute(random, visits, 3, start, end);
      OneTreeOptions sparse;
      sparse.complete_up_to = 0;
      sparse.neighbours = 2;
      const double best = optimum(route);
      const double complete_bound = oneTreeBound(route).lower_bound,
                   sparse_bound = oneTreeBound(route, sparse).lower_bound;
      EXPECT_LE(complete_bound, best + 1e-9) << visits << " visits";
      EXPECT_LE(sparse_bound, best + 1e-9) << visits << " visits";
      EXPECT_GE(sparse_bound, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoundSeeds, testing::Range<std::uint64_t>(1, 9));

// Whatever the prices: the bound must not lean on their being found well.
TEST(PairGraph, AnyPricesGiveABound) {
  std::mt19937_64 random(21);
  for (int i = 0; i < 20; ++i) {
    const Route route = randomRoute(random, 5, 3, i % 2 == 0, i % 3 == 0);
    const double best = optimum(route);
    const PostureTable table(route);
    PairGraph graph(table);
    for (int node = 1; node < table.nodes(); ++node)
      graph.add(node, static_cast<int>(random() % static_cast<std::uint64_t>(node)));
    for (int k = 0; k < 100; ++k) {
      Prices prices{std::vector<double>(table.postures()), std::vector<double>(graph.pairPrices())};
      for (double& price : prices.of_posture) price = uniform(random, -1, 1);
      for (double& price : prices.of_pair) price = uniform(random, 0, k % 2);
      EXPECT_LE(graph.completeTree(prices).bound, best + 1e-9);
    }
  }
}

// With all pairs chosen, both ways to grow the tree must meet.
TEST(PairGraph, BothTreesAgreeOnTheCompleteGraph) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 20; ++i) {
    const Route route = randomRoute(random, 12, 3, i % 2 == 0, i % 3 == 0);
    const PostureTable table(route);
    PairGraph all(table);
    for (int a = 0; a < table.nodes(); ++a) {
      for (int b = 0; b < a; ++b) all.add(a, b);
    }
    Prices prices{std::vector<double>(table.postures()), std::vector<double>(all.pairPrices())};
    for (double& price : prices.of_posture) price = uniform(random, -1, 1);
    for (double& price : prices.of_pair) price = uniform(random, 0, 1);
    EXPECT_NEAR(all.tree(prices).bound, all.completeTree(prices).bound, 1e-9);
    const std::vector<double> nothing(table.postures(), 0.0);
    const PairGraph none(table);
    EXPECT_NEAR(none.completeTree({nothing, {}}).bound,
                all.completeTree({nothing, std::vector<double>(all.pairPrices(), 0.0)}).bound, 1e-9);
  }
}

TEST(OneTreeBound, IsWithinTwoPercentForOneBranchEach) {
  int near = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const Route route = randomRoute(random, 7, 1, seed % 2 == 0, false);
    const double bound = oneTreeBound(route).lower_bound, best = optimum(route);
    EXPECT_LE(bound, best + 1e-9);
    near += bound >= 0.98 * best ? 1 : 0;
  }
  EXPECT_GE(near, 18);
}

TEST(OneTreeBound, SparseRoundsComeNearTheCompleteGraph) {
  const Route route = latticeRoute(9, 0.1, 2);
  OneTreeOptions complete, sparse;
  complete.known_time = sparse.known_time = orderVisits(route).travel_time;
  complete.complete_up_to = 100;
  sparse.complete_up_to = 0;
  const double bound = oneTreeBound(route, complete).lower_bound;
  EXPECT_NEAR(oneTreeBound(route, sparse).lower_bound, bound, 0.01 * bound);
}

TEST(OneTreeBound, HoldsForTrivialRoutes) {
  std::mt19937_64 random(9);
  Route route = randomRoute(random, 0, 1, true, true);
  EXPECT_DOUBLE_EQ(oneTreeBound(route).lower_bound, straightMoveDuration(*route.start, *route.end, route.speeds));
  route.end.reset();
  EXPECT_EQ(oneTreeBound(route).lower_bound, 0);
  const Route single = randomRoute(random, 1, 1, true, true);
  const double there = straightMoveDuration(*single.start, single.visits[0].branches[0], single.speeds);
  const double onwards = straightMoveDuration(single.visits[0].branches[0], *single.end, single.speeds);
  EXPECT_NEAR(oneTreeBound(single).lower_bound, there + onwards, 1e-9);
}

TEST(OneTreeBound, IgnoresExtraTimeAndRefusesBadInput) {
  std::mt19937_64 random(10);
  Route route = randomRoute(random, 6, 2, true, false);
  const double bound = oneTreeBound(route).lower_bound;
  route.extra_time = [](int, int, int, int) { return 5.0; };
  EXPECT_EQ(oneTreeBound(route).lower_bound, bound);
  route.visits[2].branches.clear();
  EXPECT_EQ(oneTreeBound(route).status, OneTreeStatus::kBadInput);
  EXPECT_TRUE(std::isnan(oneTreeBound(route).lower_bound));
}

}  // namespace
}  // namespace tubeplan::planner
