// All branches of eight arms compared with random starts: the short form of studies/branch_counts.cpp.
#include "tests/planner/reach/branch_count.hpp"

#include <gtest/gtest.h>

namespace tubeplan::planner {
namespace {

TEST(BranchCount, WhatRandomStartsFindIsFoundAndNothingIsFalse) {
  for (const auto& arm : testing::countedArms(6)) {
    ASSERT_FALSE(arm.places_W.empty()) << arm.name;
    const testing::BranchCount count = testing::countBranches(arm.cell, arm.places_W, 150, 1);
    EXPECT_GE(count.brute, 1) << arm.name;
    EXPECT_EQ(count.missed, 0) << arm.name << " of " << count.brute;
    EXPECT_EQ(count.without, 0) << arm.name;
    EXPECT_GE(count.branches, 1) << arm.name;
    EXPECT_EQ(count.wrong, 0) << arm.name << " of " << count.branches;
  }
}

}  // namespace
}  // namespace tubeplan::planner
