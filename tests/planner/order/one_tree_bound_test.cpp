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

double bestOfAllOrders(const Route& route) {
  std::vector<int> order(route.visits.size());
  std::iota(order.begin(), order.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    best = std::min(best, bestBranches(route, order).travel_time);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

class BoundSeeds : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(BoundSeeds, NeverAboveTheOptimum) {
  std::mt19937_64 random(GetParam());
  for (const auto& [start, end] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
    for (int visits = 1; visits <= 6; ++visits) {
      const Route route = randomRoute(random, visits, 3, start, end);
      OneTreeOptions sparse;
      sparse.complete_up_to = 0;
      sparse.neighbours = 2;
      const double best = bestOfAllOrders(route);
      const double complete_bound = oneTreeBound(route).lower_bound,
                   sparse_bound = oneTreeBound(route, sparse).lower_bound;
      EXPECT_LE(complete_bound, best + 1e-9) << visits << " visits";
      EXPECT_LE(sparse_bound, best + 1e-9) << visits << " visits";
      EXPECT_GE(sparse_bound, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoundSeeds, ::testing::Range<std::uint64_t>(1, 9));

/// Returns a random set of postures that contains all postures of one node and none of another node.
std::vector<char> randomCut(std::mt19937_64& random, const PostureTable& table) {
  std::vector<char> inside(static_cast<std::size_t>(table.postures()));
  for (char& side : inside) side = static_cast<char>(random() % 2);
  const int in = static_cast<int>(random() % static_cast<std::uint64_t>(table.nodes())), out = (in + 1) % table.nodes();
  std::fill(inside.begin() + table.first(in), inside.begin() + table.last(in), 1);
  std::fill(inside.begin() + table.first(out), inside.begin() + table.last(out), 0);
  return inside;
}

// The bound must be valid for any prices, however badly they are chosen.
TEST(PairGraph, AnyPricesGiveABound) {
  std::mt19937_64 random(21);
  for (int i = 0; i < 20; ++i) {
    const Route route = randomRoute(random, 5, 3, i % 2 == 0, i % 3 == 0);
    const double best = bestOfAllOrders(route);
    const PostureTable table(route);
    PairGraph graph(table);
    for (int node = 1; node < table.nodes(); ++node)
      graph.add(node, static_cast<int>(random() % static_cast<std::uint64_t>(node)));
    for (int cut = 0; cut < 3; ++cut) graph.addCut(randomCut(random, table));
    for (int k = 0; k < 100; ++k) {
      Prices prices{std::vector<double>(table.postures()), std::vector<double>(graph.pairPrices()),
                    std::vector<double>(graph.cuts())};
      for (double& price : prices.of_cut) price = uniform(random, 0, k % 3);
      for (double& price : prices.of_posture) price = uniform(random, -1, 1);
      for (double& price : prices.of_pair) price = uniform(random, 0, k % 2);
      EXPECT_LE(graph.completeTree(prices).bound, best + 1e-9);
    }
  }
}

// On the complete graph both methods of growing the tree must give the same bound.
TEST(PairGraph, BothTreesAgreeOnTheCompleteGraph) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 20; ++i) {
    const Route route = randomRoute(random, 12, 3, i % 2 == 0, i % 3 == 0);
    const PostureTable table(route);
    PairGraph all(table);
    for (int a = 0; a < table.nodes(); ++a) {
      for (int b = 0; b < a; ++b) all.add(a, b);
    }
    for (int cut = 0; cut < 5; ++cut) all.addCut(randomCut(random, table));
    Prices prices{std::vector<double>(table.postures()), std::vector<double>(all.pairPrices()),
                  std::vector<double>(all.cuts())};
    for (double& price : prices.of_cut) price = uniform(random, 0, 1);
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
    const double bound = oneTreeBound(route).lower_bound, best = bestOfAllOrders(route);
    EXPECT_LE(bound, best + 1e-9);
    near += bound >= 0.98 * best ? 1 : 0;
  }
  EXPECT_GE(near, 18);
}

// Some visits have postures of one family, some of a distant second family, and some of both. A tree changes families
// at no cost at visits with both, but a route cannot: only with cuts does the bound include the time of that move.
TEST(OneTreeBound, CountsTheMoveBetweenTwoFamiliesOfPostures) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 5; ++trial) {
    Route route;
    route.speeds = {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2)};
    const Eigen::VectorXd beyond = Eigen::Vector3d(30, 0, 0);
    for (int visit = 0; visit < 7; ++visit) {
      const Eigen::VectorXd q = postureWithinOne(random, 3);
      auto& branches = route.visits.emplace_back().branches;
      if (visit < 5) branches.push_back(q);
      if (visit > 1) branches.push_back(q + beyond);
    }
    OneTreeOptions without;
    without.known_time = bestOfAllOrders(route);
    without.cut_rounds = 0;
    OneTreeOptions with = without;
    with.cut_rounds = 12;
    EXPECT_LT(oneTreeBound(route, without).lower_bound, 0.5 * without.known_time);
    EXPECT_GT(oneTreeBound(route, with).lower_bound, 0.95 * without.known_time);
    EXPECT_LE(oneTreeBound(route, with).lower_bound, without.known_time + 1e-9);
  }
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
  const double approach = straightMoveDuration(*single.start, single.visits[0].branches[0], single.speeds);
  const double onwards = straightMoveDuration(single.visits[0].branches[0], *single.end, single.speeds);
  EXPECT_NEAR(oneTreeBound(single).lower_bound, approach + onwards, 1e-9);
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
