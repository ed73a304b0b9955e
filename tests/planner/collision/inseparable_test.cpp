// Tests that bodies which touch in every posture are listed and not checked, and that all other bodies more than one
// joint apart are checked.
#include "planner/collision/inseparable.hpp"

#include <gtest/gtest.h>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using testing::shape;
using Pairs = std::vector<std::pair<int, int>>;

/// Returns an arm of three joints with parallel axes: a forearm, a wrist of length `wrist` without a body, and a hand.
deflection::Arm armWithWrist(double wrist) {
  deflection::Arm arm;
  for (const auto& [name, from] : {std::pair{"forearm", 0.0}, {"wrist", 1.0}, {"hand", wrist}}) {
    deflection::Row<double> row;
    row.name = name;
    row.placement = deflection::Origin<double>{{from, 0, 0}, {0, 0, 0}};
    row.joint.type = deflection::JointType::kRevolute;
    row.joint.name = std::string("joint-of-") + name;
    row.joint.lower = -2;
    row.joint.upper = 2;
    arm.rows.push_back(row);
  }
  arm.p_LT = {0.3, 0, 0};
  return arm;
}

Scene sceneOf(const deflection::Arm& arm) {
  Scene scene;
  for (const auto& row : arm.rows) scene.links.push_back({row.name, true});
  scene.bodies.push_back({"forearm", 0, "", shape("capsule", {0, 0, 0, 1, 0, 0, 0.05}), {}});
  scene.bodies.push_back({"hand", 2, "", shape("capsule", {0, 0, 0, 0.3, 0, 0, 0.05}), {}});
  return scene;
}

TEST(Inseparable, AHandOnAWristThatIsShorterThanItIsThick) {
  const deflection::Arm arm = armWithWrist(0.06);
  EXPECT_EQ(inseparableBodies(arm, sceneOf(arm)), (Pairs{{0, 1}}));
}

TEST(Inseparable, NoneWhereSomePosturePartsThem) {
  const deflection::Arm arm = armWithWrist(0.2);
  EXPECT_EQ(inseparableBodies(arm, sceneOf(arm)), Pairs{});
}

TEST(Inseparable, WithinTheClearanceCountsAsNear) {
  const deflection::Arm arm = armWithWrist(0.12);
  Scene scene = sceneOf(arm);
  EXPECT_EQ(inseparableBodies(arm, scene), Pairs{});
  scene.clearance = 0.03;
  EXPECT_EQ(inseparableBodies(arm, scene), (Pairs{{0, 1}}));
  scene.bodies[1].allow = {"forearm"};
  EXPECT_EQ(inseparableBodies(arm, scene), Pairs{});
}

/// Contact of a hand folded back onto the forearm is found, although the wrist between them has no body.
TEST(CollisionWorld, JudgesBodiesAcrossALinkWithoutShapes) {
  const testing::ToyArm toy{{1, 1, 1}, 0.05};
  Scene scene = toy.scene({});
  scene.bodies.erase(scene.bodies.begin() + 1);
  const CollisionWorld world(scene);
  const double turn = 2 * std::numbers::pi / 3;
  const Clearance folded = world.closest(toy.frames(Eigen::Vector3d(0, turn, turn)));
  EXPECT_NEAR(folded.distance, -0.1, 1e-12);
  scene.inseparable = {{0, 1}};
  EXPECT_TRUE(CollisionWorld(scene).allPairs(toy.frames(Eigen::Vector3d(0, turn, turn))).empty());
}

}  // namespace
}  // namespace tubeplan::planner
