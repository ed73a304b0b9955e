#include "planner/order/branch_choice.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/planner/order/route_fixtures.hpp"

namespace tubeplan::planner {
namespace {

std::vector<int> shuffledOrder(std::mt19937_64& random, int visits) {
  std::vector<int> order(visits);
  std::iota(order.begin(), order.end(), 0);
  for (int i = visits - 1; i > 0; --i) std::swap(order[i], order[random() % static_cast<std::uint64_t>(i + 1)]);
  return order;
}

TEST(BestBranches, EqualsTryingEveryChoice) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const Route route = randomRoute(random, 6, 4, seed % 2 == 0, seed % 3 == 0);
    const std::vector<int> order = shuffledOrder(random, 6);
    const BranchChoice choice = bestBranches(route, order);
    ASSERT_EQ(choice.status, BranchChoiceStatus::kSolved);
    EXPECT_NEAR(choice.travel_time, exhaustiveBranches(route, order), 1e-12);
    EXPECT_NEAR(choice.travel_time, timeOf(route, order, choice.branches), 1e-12);
  }
}

TEST(BestBranches, PaysExtraTimeOnlyWhereItIsCheaper) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 30; ++i) {
    Route route = randomRoute(random, 5, 3, true, true);
    EdgePenalties penalties;
    for (int k = 0; k < 40; ++k) {
      const int a = static_cast<int>(random() % 7) - 2, b = static_cast<int>(random() % 7) - 2;
      const int branch_a = a < 0 ? 0 : static_cast<int>(random() % route.visits[a].branches.size());
      const int branch_b = b < 0 ? 0 : static_cast<int>(random() % route.visits[b].branches.size());
      if (a != b) penalties.set(a, branch_a, b, branch_b, uniform(random, 0, 2));
    }
    route.extra_time = penalties;
    const std::vector<int> order = shuffledOrder(random, 5);
    EXPECT_NEAR(bestBranches(route, order).travel_time, exhaustiveBranches(route, order), 1e-12);
  }
}

TEST(BestBranches, SaysWhenEveryChoiceIsForbidden) {
  std::mt19937_64 random(6);
  Route route = randomRoute(random, 3, 1, false, false);
  EdgePenalties penalties;
  penalties.set(1, 0, 0, 0, std::numeric_limits<double>::infinity());
  route.extra_time = penalties;
  const BranchChoice barred = bestBranches(route, {0, 1, 2});
  EXPECT_EQ(barred.status, BranchChoiceStatus::kForbiddenMove);
  EXPECT_TRUE(std::isinf(barred.travel_time));
  EXPECT_FALSE(barred.reason.empty());
  EXPECT_EQ(bestBranches(route, {0, 2, 1}).status, BranchChoiceStatus::kSolved);
}

TEST(BestBranches, RefusesAnOrderThatRepeatsOrInvents) {
  std::mt19937_64 random(7);
  const Route route = randomRoute(random, 3, 2, false, false);
  EXPECT_EQ(bestBranches(route, {0, 1, 1}).status, BranchChoiceStatus::kBadInput);
  EXPECT_EQ(bestBranches(route, {0, 3}).status, BranchChoiceStatus::kBadInput);
  EXPECT_EQ(bestBranches(route, {2, 0}).status, BranchChoiceStatus::kSolved);
}

TEST(EdgePenalties, HoldBothWaysAndKnowNothingElse) {
  EdgePenalties penalties;
  penalties.set(4, 1, 2, 0, 0.5);
  penalties.set(kStartPosture, 0, 4, 1, 0.25);
  penalties.set(2, 0, 4, 1, 0.75);
  EXPECT_EQ(penalties(4, 1, 2, 0), 0.75);
  EXPECT_EQ(penalties(2, 0, 4, 1), 0.75);
  EXPECT_EQ(penalties(4, 1, kStartPosture, 0), 0.25);
  EXPECT_EQ(penalties(4, 0, 2, 0), 0);
  EXPECT_EQ(penalties(4, 1, kEndPosture, 0), 0);
  EXPECT_EQ(penalties(4, 1, 900, 0), 0);
  EXPECT_EQ(penalties.size(), 2U);
}

TEST(FindRouteProblems, NamesTheVisit) {
  std::mt19937_64 random(8);
  Route route = randomRoute(random, 3, 1, true, false);
  EXPECT_TRUE(findRouteProblems(route).empty());
  route.visits[1].branches.clear();
  route.visits[2].branches[0][1] = std::nan("");
  route.start = Eigen::VectorXd::Zero(2);
  const std::vector<std::string> problems = findRouteProblems(route);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_NE(problems[0].find("visit 1"), std::string::npos);
  EXPECT_NE(problems[1].find("visit 2"), std::string::npos);
  EXPECT_NE(problems[2].find("start"), std::string::npos);
}

TEST(SerpentineOrder, TurnsAtTheEndOfEachRow) {
  const std::vector<int> rows{2, 1, 1, 2, 5, 1, 5}, columns{1, 3, 1, 4, 7, 2, 9};
  EXPECT_EQ(serpentineOrder(rows, columns), (std::vector<int>{2, 5, 1, 3, 0, 4, 6}));
}

TEST(SerpentineOrder, TakesNoMoreThanAnyOneBranchThroughout) {
  const Route route = latticeRoute(5, 0.1, 2);
  std::vector<int> rows, columns;
  for (int i = 0; i < 25; ++i) {
    rows.push_back(i / 5);
    columns.push_back(i % 5);
  }
  const std::vector<int> order = serpentineOrder(rows, columns);
  const BranchChoice best = bestBranches(route, order);
  const double time = best.travel_time;
  EXPECT_NEAR(time, timeOf(route, order, best.branches), 1e-12);
  EXPECT_LE(time, timeOf(route, order, std::vector<int>(25, 0)) + 1e-12);
  EXPECT_LE(time, timeOf(route, order, std::vector<int>(25, 1)) + 1e-12);
}

}  // namespace
}  // namespace tubeplan::planner
