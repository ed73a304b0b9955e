#include "planner/scene/scene.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using testing::shape;
using testing::ToyArm;

bool hasProblem(const std::vector<SceneProblem>& problems, const std::string& path, const std::string& found) {
  return std::ranges::any_of(problems, [&](const SceneProblem& problem) {
    return problem.path.find(path) != std::string::npos && problem.found.find(found) != std::string::npos;
  });
}

Scene plainScene() { return ToyArm{{1, 1, 1}}.scene({{"wall", shape("keep_side", {2, 0, 0, -1, 0, 0}), {}}}); }

TEST(SceneProblems, NoneInASoundScene) {
  Scene scene = plainScene();
  scene.links.push_back({"bare", true});  // a link without bodies may be listed too
  scene.obstacles[0].allow = {"link3", "bare"};
  scene.bodies[0].allow = {"wall", "link3"};
  EXPECT_TRUE(findSceneProblems(scene).empty());
}

TEST(SceneProblems, EachIsTold) {
  Scene scene = plainScene();
  scene.clearance = -1;
  scene.obstacles.push_back(scene.obstacles[0]);
  scene.obstacles.push_back({"", nullptr, {"elbow"}});
  scene.bodies.push_back({"link9", 1, "thing", shape("keep_side", {0, 0, 0, 1, 0, 0}), {"cupboard"}});
  const auto problems = findSceneProblems(scene);
  EXPECT_TRUE(hasProblem(problems, "clearance", "-1"));
  EXPECT_TRUE(hasProblem(problems, "obstacle wall: name", "the same name"));
  EXPECT_TRUE(hasProblem(problems, "obstacle 3: name", "nothing"));
  EXPECT_TRUE(hasProblem(problems, "obstacle 3", "no shape"));
  EXPECT_TRUE(hasProblem(problems, "obstacle 3: allow", "elbow"));
  EXPECT_TRUE(hasProblem(problems, "body thing: link", "link9"));
  EXPECT_TRUE(hasProblem(problems, "body thing", "a region"));
  EXPECT_TRUE(hasProblem(problems, "body thing: allow", "cupboard"));
  EXPECT_EQ(problems.size(), 8u);
}

TEST(AreJudged, BodiesWithMoreThanOneJointBetweenThem) {
  Scene scene;
  scene.links = {{"pedestal", false}, {"shoulder", true}, {"bracket", false}, {"wrist", true}, {"hand", true}};
  const auto body = [&](int i) { return Body{scene.links[i].name, i, "", shape("sphere", {0, 0, 0, 0.1}), {}}; };
  scene.bodies = {body(0), body(1), body(2), body(4), body(4)};
  std::set<std::pair<int, int>> judged;
  for (int b = 0; b < 5; ++b)
    for (int a = 0; a < b; ++a)
      if (areJudged(scene, a, b)) judged.emplace(a, b);
  // Two joints lie between bracket and hand, so these are checked although the wrist between them has no body.
  EXPECT_EQ(judged, (std::set<std::pair<int, int>>{{0, 3}, {0, 4}, {1, 3}, {1, 4}, {2, 3}, {2, 4}}));
  scene.inseparable = {{2, 3}};
  EXPECT_FALSE(areJudged(scene, 2, 3));
  EXPECT_FALSE(areJudged(scene, 3, 2));
  EXPECT_TRUE(areJudged(scene, 2, 4));
}

TEST(MayTouch, ByLinkOrBodyNameFromEitherSide) {
  Scene scene = plainScene();
  Body tip{"link3", 2, "tip", shape("sphere", {1, 0, 0, 0.1}), {}};
  EXPECT_FALSE(mayTouch(scene.obstacles[0], tip));
  scene.obstacles[0].allow = {"tip"};
  EXPECT_TRUE(mayTouch(scene.obstacles[0], tip));
  EXPECT_FALSE(mayTouch(scene.obstacles[0], scene.bodies[2]));
  scene.obstacles[0].allow = {"link3"};
  EXPECT_TRUE(mayTouch(scene.obstacles[0], tip));
  EXPECT_TRUE(mayTouch(scene.obstacles[0], scene.bodies[2]));
  EXPECT_FALSE(mayTouch(scene.bodies[0], tip));
  tip.allow = {"link1"};
  EXPECT_TRUE(mayTouch(scene.bodies[0], tip));
  EXPECT_TRUE(mayTouch(tip, scene.bodies[0]));
}

}  // namespace
}  // namespace tubeplan::planner
