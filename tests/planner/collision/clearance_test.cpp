#include "planner/collision/clearance.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::VectorXd;
using testing::shape;
using testing::ToyArm;

VectorXd posture(std::initializer_list<double> angles) {
  VectorXd q(static_cast<Eigen::Index>(angles.size()));
  std::ranges::copy(angles, q.data());
  return q;
}

TEST(CollisionWorld, NamesTheNearestPairAndItsPoint) {
  const ToyArm arm{{1, 1, 1}, 0.05, 0.1};
  const CollisionWorld world(arm.scene({{"wall", shape("keep_side", {3.5, 0, 0, -1, 0, 0}), {}},
                                        {"post", shape("cylinder", {1.5, 0.4, -1, 1.5, 0.4, 1, 0.2}), {}}}));
  const Clearance found = world.closest(arm.frames(posture({0, 0, 0})));
  EXPECT_NEAR(found.distance, 0.15, 1e-9);
  EXPECT_NEAR(found.margin, 0.05, 1e-9);
  EXPECT_EQ(found.body, "link2");
  EXPECT_EQ(found.other, "post");
  EXPECT_NEAR((found.point_W - Eigen::Vector3d(1.5, 0.05, 0)).head<2>().norm(), 0, 1e-6);
  EXPECT_NE(describe(found).find("link2 is 0.1500 m from post, 0.1000 m required"), std::string::npos);
}

TEST(CollisionWorld, SelfCollisionOfLinksThatShareNoJoint) {
  const ToyArm arm{{1, 1, 1}, 0.05};
  const CollisionWorld world(arm.scene({}));
  // The links form a triangle: the third link ends at the start of the first, so the two overlap.
  const double turn = 2 * std::numbers::pi / 3;
  const Clearance folded = world.closest(arm.frames(posture({0, turn, turn})));
  EXPECT_NEAR(folded.distance, -0.1, 1e-12);
  EXPECT_EQ(folded.body, "link3");
  EXPECT_EQ(folded.other, "link1");
  EXPECT_NEAR(world.closest(arm.frames(posture({0, 0, 0}))).distance, 1 - 0.1, 1e-12);
  // The links form a square bracket: the axes of the first and third links are parallel, one length apart.
  const double square = std::numbers::pi / 2;
  EXPECT_NEAR(world.closest(arm.frames(posture({0.3, square, square}))).distance, 1 - 0.1, 1e-12);
}

TEST(CollisionWorld, NeighboursAreNeverJudged) {
  const ToyArm arm{{1, 1}, 0.05};
  const CollisionWorld world(arm.scene({}));
  const Clearance found = world.closest(arm.frames(posture({0, 3.1})));
  EXPECT_TRUE(std::isinf(found.margin));
  EXPECT_EQ(describe(found), "nothing is near the arm");
  EXPECT_TRUE(world.allPairs(arm.frames(posture({0, 3.1}))).empty());
}

TEST(CollisionWorld, AllowedPairsDoNotCountButAreListed) {
  const ToyArm arm{{1, 1, 1}, 0.05, 0.1};
  Scene scene = arm.scene({{"wall", shape("keep_side", {2.9, 0, 0, -1, 0, 0}), {"link3"}}});
  scene.bodies[0].allow = {"link3"};
  const CollisionWorld world(scene);
  const Clearance found = world.closest(arm.frames(posture({0, 0, 0})));
  EXPECT_EQ(found.body, "link2");
  EXPECT_NEAR(found.distance, 0.85, 1e-12);
  const auto pairs = world.allPairs(arm.frames(posture({0, 0, 0})));
  ASSERT_EQ(pairs.size(), 4u);
  EXPECT_TRUE(pairs[0].allowed);
  EXPECT_NEAR(pairs[0].clearance.distance, -0.15, 1e-12);
  EXPECT_TRUE(std::isinf(pairs[0].clearance.margin));
}

TEST(CollisionWorld, ClosestIsTheLeastOfAllPairs) {
  const ToyArm arm{{0.6, 0.5, 0.4, 0.3}, 0.04, 0.02};
  const CollisionWorld world(arm.scene({{"bowl", shape("inside_of.sphere", {0, 0, 0, 1.9}), {}},
                                        {"post", shape("cylinder", {1, 0.4, -1, 1, 0.4, 1, 0.1}), {}},
                                        {"block", shape("box", {-0.5, 0.8, 0, 0.3, 0.3, 0.3, 0, 0, 0.5}), {}},
                                        {"pipe", shape("capsule", {0, -1, -1, 0.3, -1, 1, 0.1}), {"link4"}}}));
  std::mt19937_64 generator(8);
  std::set<std::string> seen;
  for (int i = 0; i < 3000; ++i) {
    VectorXd q(4);
    for (double& angle : q) angle = testing::uniform(generator, -2.5, 2.5);
    const auto frames = arm.frames(q);
    const auto pairs = world.allPairs(frames);
    const auto first = std::ranges::find_if(pairs, [](const PairClearance& pair) { return !pair.allowed; });
    const Clearance found = world.closest(frames);
    EXPECT_NEAR(found.distance, first->clearance.distance, 1e-9);
    EXPECT_NEAR(found.margin, found.distance - 0.02, 1e-15);
    seen.insert(found.other);
  }
  EXPECT_GE(seen.size(), 5u);
}

TEST(CollisionWorld, APoseThatIsNotANumberIsNeverFree) {
  const ToyArm arm{{1, 1, 1}};
  const CollisionWorld world(arm.scene({{"wall", shape("keep_side", {9, 0, 0, -1, 0, 0}), {}}}));
  auto frames = arm.frames(posture({0, 0, 0}));
  frames[1].translation().x() = std::nan("");
  const Clearance found = world.closest(frames);
  EXPECT_FALSE(found.margin >= 0);
  EXPECT_EQ(describe(found), "link2: its pose is not a number");
}

TEST(Clearance, BodyReach) {
  const auto reach = bodyReachOf(ToyArm{{0.6, 0.5}, 0.04}.scene({}));
  EXPECT_NEAR(reach[0], 0.64, 1e-15);
  EXPECT_NEAR(reach[1], 0.54, 1e-15);
}

}  // namespace
}  // namespace tubeplan::planner
