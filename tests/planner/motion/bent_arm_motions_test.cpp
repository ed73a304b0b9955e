#include "tests/planner/motion/bent_arm_motions.hpp"

#include <gtest/gtest.h>

namespace tubeplan::planner {
namespace {

/// No motion found free has a sampled margin smaller than the proved one. studies/motion_proofs.cpp repeats this test
/// with more motions and finer sampling.
TEST(BentArmAmongThinPlates, NoMotionCalledFreeIsRefutedByFineSteps) {
  const auto tally = testing::tallyBentArmMotions(1, 200, 500);
  EXPECT_EQ(tally.refuted, 0);
  EXPECT_GT(tally.free, 40);
  EXPECT_GT(tally.blocked, 20);
}

}  // namespace
}  // namespace tubeplan::planner
