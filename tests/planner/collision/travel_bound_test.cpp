#include "planner/collision/travel_bound.hpp"

#include <gtest/gtest.h>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::VectorXd;
using Joint = LinkReach::Joint;

TEST(TravelBound, AddsUpTheChain) {
  const std::vector<LinkReach> links = {{0.3, 0.1, Joint::kNone},
                                        {0.5, 0.2, Joint::kRevolute},
                                        {0.0, 0.0, Joint::kPrismatic},
                                        {0, 0.25, Joint::kRevolute}};
  const TravelBound bound = travelBoundOf(links, 1.2);
  ASSERT_EQ(bound.reach_per_joint.size(), 3);
  EXPECT_NEAR(bound.reach_per_joint[0], 1.2 * 0.75, 1e-15);
  EXPECT_NEAR(bound.reach_per_joint[1], 1.2, 1e-15);
  EXPECT_NEAR(bound.reach_per_joint[2], 1.2 * 0.25, 1e-15);
  EXPECT_NEAR(bound(VectorXd::Zero(3), Eigen::Vector3d(0.1, -0.2, 0.3)), 1.2 * (0.075 + 0.2 + 0.075), 1e-15);
}

TEST(TravelBound, NoClearanceChangesFasterThanTheBound) {
  const testing::ToyArm arm{{0.6, 0.5, 0.4, 0.3}, 0.04};
  const CollisionWorld world(
      arm.scene({{"bowl", testing::shape("inside_of.sphere", {0, 0, 0, 1.9}), {}},
                 {"block", testing::shape("box", {-0.5, 0.8, 0, 0.3, 0.3, 0.3, 0, 0, 0.5}), {}}}));
  const TravelBound bound = arm.travel(world);
  std::mt19937_64 generator(4);
  for (int i = 0; i < 5000; ++i) {
    VectorXd q0(4), q1(4);
    for (double& angle : q0) angle = testing::uniform(generator, -2.5, 2.5);
    for (int j = 0; j < 4; ++j) q1[j] = q0[j] + testing::uniform(generator, -0.1, 0.1);
    const auto pairs0 = world.allPairs(arm.frames(q0)), pairs1 = world.allPairs(arm.frames(q1));
    for (const auto& a : pairs0)
      for (const auto& b : pairs1) {
        if (a.clearance.body != b.clearance.body || a.clearance.other != b.clearance.other) continue;
        if (a.clearance.distance < 0 || b.clearance.distance < 0) continue;
        EXPECT_LE(std::abs(a.clearance.distance - b.clearance.distance), bound(q0, q1) + 1e-8);
      }
  }
}

}  // namespace
}  // namespace tubeplan::planner
