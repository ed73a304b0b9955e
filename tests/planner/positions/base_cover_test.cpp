// Choice of base positions against exhaustive search, and its bounds where the search ends early.
#include "planner/positions/base_cover.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace tubeplan::planner {
namespace {

std::vector<std::vector<bool>> drawnReach(std::mt19937_64& random, int candidates, int tubes, double share) {
  std::bernoulli_distribution reached(share);
  std::vector<std::vector<bool>> reaches(static_cast<std::size_t>(candidates));
  for (auto& row : reaches)
    for (int t = 0; t < tubes; ++t) row.push_back(reached(random));
  return reaches;
}

int reachedBy(const std::vector<std::vector<bool>>& reaches, unsigned chosen) {
  int count = 0;
  for (std::size_t t = 0; t < reaches.front().size(); ++t) {
    bool is_reached = false;
    for (std::size_t c = 0; c < reaches.size(); ++c) is_reached |= (chosen >> c & 1u) != 0 && reaches[c][t];
    count += is_reached;
  }
  return count;
}

unsigned bitsOf(const std::vector<int>& candidates) {
  unsigned bits = 0;
  for (const int c : candidates) bits |= 1u << c;
  return bits;
}

TEST(BaseCover, NoOtherChoiceIsBetter) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const int candidates = 3 + trial % 8;
    const auto reaches = drawnReach(random, candidates, 40, 0.15 + 0.05 * (trial % 5));
    const BaseCover cover = coverByBases(reaches, {.most = 1 + trial % 3});
    ASSERT_EQ(cover.status, BaseCoverStatus::kProved);
    EXPECT_LE(cover.best.size(), static_cast<std::size_t>(1 + trial % 3));
    EXPECT_EQ(reachedBy(reaches, bitsOf(cover.best)), cover.reached);
    EXPECT_EQ(reachedBy(reaches, bitsOf(cover.all)), cover.reachable);
    for (unsigned chosen = 0; chosen < 1u << candidates; ++chosen) {
      const int count = std::popcount(chosen), reached = reachedBy(reaches, chosen);
      if (count <= 1 + trial % 3) {
        EXPECT_LE(reached, cover.reached);
      }
      if (reached == cover.reachable) {
        EXPECT_GE(count, cover.at_least);
      }
    }
    EXPECT_EQ(cover.at_least, static_cast<int>(cover.all.size()));
  }
}

TEST(BaseCover, BoundsHoldWhereTheSearchEndsEarly) {
  std::mt19937_64 random(4);
  const auto reaches = drawnReach(random, 60, 400, 0.1);
  const BaseCover proved = coverByBases(reaches, {.most = 2}),
                  early = coverByBases(reaches, {.most = 2, .most_nodes = 3});
  EXPECT_EQ(early.status, BaseCoverStatus::kNotProved);
  EXPECT_LE(early.reached, proved.reached);
  EXPECT_GE(early.at_most, proved.reached);
  EXPECT_LE(early.at_least, static_cast<int>(proved.all.size()));
}

TEST(BaseCover, OfNothingReachesNothing) {
  EXPECT_EQ(coverByBases({}).status, BaseCoverStatus::kNothingReached);
  EXPECT_EQ(coverByBases({{false, false}, {false, false}}).status, BaseCoverStatus::kNothingReached);
}

}  // namespace
}  // namespace tubeplan::planner
