#include "tests/planner/motion/adversarial_motions.hpp"

#include <gtest/gtest.h>

namespace tubeplan::planner {
namespace {

class AdversarialScene : public ::testing::TestWithParam<int> {};

/// No motion found free has a sampled margin smaller than the proved one. studies/motion_proofs.cpp repeats this test
/// with more motions and finer sampling.
TEST_P(AdversarialScene, NoMotionCalledFreeIsRefutedByFineSteps) {
  const auto tally = testing::tallyMotions(GetParam(), 1, 200, 500);
  EXPECT_EQ(tally.refuted, 0);
  EXPECT_GT(tally.free, 40);
  EXPECT_GT(tally.blocked, 20);
}

INSTANTIATE_TEST_SUITE_P(Scenes, AdversarialScene, ::testing::Range(0, testing::kAdversarialScenes));

}  // namespace
}  // namespace tubeplan::planner
