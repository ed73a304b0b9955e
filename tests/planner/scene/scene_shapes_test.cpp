#include "planner/scene/scene_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>
#include <set>

#include "planner/scene/outline.hpp"
#include "tests/planner/scene/meshes.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

/// Returns valid values for all fields of a shape's row.
std::vector<double> plainNumbers(const ShapeRow& row) {
  std::vector<double> numbers;
  for (const ShapeField& field : row.fields)
    for (int i = 0; i < field.count; ++i)
      numbers.push_back(field.quantity == ShapeQuantity::kSize ? 0.5 : 0.1 * (1.0 + double(numbers.size())));
  return numbers;
}

TEST(SceneShapes, EveryRowIsCompleteAndBuildsAShapeWithFiniteDistances) {
  std::set<std::string_view> keys;
  for (const ShapeRow& row : sceneShapes()) {
    SCOPED_TRACE(row.key);
    EXPECT_TRUE(keys.insert(row.key).second);
    EXPECT_FALSE(row.help.empty());
    const TriangleMesh mesh = testing::boxMesh({0.1, 0.2, 0.3});
    const MadeShape made = makeShape(row, plainNumbers(row), findMeshField(row) ? &mesh : nullptr);
    ASSERT_TRUE(made.shape) << made.problem;
    EXPECT_TRUE(std::isfinite(made.shape->pointDistance({3, 2, 1})));
    const auto body = testing::shape("capsule", {0, 0, 0, 0.1, 0, 0, 0.01});
    EXPECT_TRUE(std::isfinite(
        made.shape->separationFrom(Eigen::Isometry3d::Identity(), dynamic_cast<const Solid&>(*body)).distance));
    EXPECT_EQ(dynamic_cast<const Solid*>(made.shape.get()) != nullptr, row.may_be_body);
    EXPECT_EQ(findSceneShape(row.key), &row);
  }
  EXPECT_EQ(findSceneShape("teapot"), nullptr);
}

TEST(SceneShapes, EverySolidKeepsItsPromises) {
  std::mt19937_64 generator(5);
  for (const ShapeRow& row : sceneShapes()) {
    if (!row.may_be_body) continue;
    SCOPED_TRACE(row.key);
    const auto made = makeShape(row, plainNumbers(row));
    const auto& solid = dynamic_cast<const Solid&>(*made.shape);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p = testing::uniformVector(generator, -2, 2),
                            direction = testing::uniformVector(generator, -1, 1);
      const Eigen::Vector3d farthest = solid.farthestFrom(p), support = solid.support(direction);
      EXPECT_NEAR(solid.pointDistance(farthest), 0, 1e-12);
      EXPECT_NEAR(solid.pointDistance(support), 0, 1e-12);
      const auto& [from, to, radius] = solid.around();
      EXPECT_LE(testing::shape("capsule", {from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), radius})
                    ->pointDistance(farthest),
                1e-9);
      // No point of the solid extends farther along `direction` than `support`, or lies farther from `p` than
      // `farthest`.
      const Eigen::Vector3d inside = testing::uniformVector(generator, -1, 2);
      if (solid.pointDistance(inside) > 0) continue;
      EXPECT_LE(direction.dot(inside), direction.dot(support) + 1e-12);
      EXPECT_LE((inside - p).norm(), (farthest - p).norm() + 1e-12);
    }
  }
}

TEST(SceneShapes, TheHullOfAnOutlineIsTheSolid) {
  std::mt19937_64 generator(6);
  for (const ShapeRow& row : sceneShapes()) {
    if (!row.may_be_body) continue;
    SCOPED_TRACE(row.key);
    const auto made = makeShape(row, plainNumbers(row));
    const auto& solid = dynamic_cast<const Solid&>(*made.shape);
    const auto points = outlineOf(solid);
    if (solid.box()) EXPECT_EQ(points.size(), 8u);
    for (const Eigen::Vector3d& point : points) EXPECT_NEAR(solid.pointDistance(point), 0, 1e-12);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d direction = testing::uniformVector(generator, -1, 1).normalized();
      const auto along = [&](const Eigen::Vector3d& point) { return direction.dot(point); };
      const double reach = along(solid.support(direction)),
                   farthest = std::ranges::max(points | std::views::transform(along));
      EXPECT_NEAR(farthest, reach, 0.02 * solid.around().radius);
    }
  }
}

TEST(SceneShapes, NumbersThatMakeNoSenseAreTold) {
  const auto problem = [](const char* key, std::vector<double> numbers) {
    return makeShape(*findSceneShape(key), numbers).problem;
  };
  EXPECT_NE(problem("sphere", {0, 0, 0, -1}).find("radius"), std::string::npos);
  EXPECT_NE(problem("sphere", {0, 0, 0}).find("4 numbers"), std::string::npos);
  EXPECT_NE(problem("keep_side", {0, 0, 0, 0, 0, 0}).find("normal"), std::string::npos);
  EXPECT_NE(problem("box", {0, 0, std::nan(""), 1, 1, 1, 0, 0, 0}).find("center"), std::string::npos);
  EXPECT_NE(problem("box", {0, 0, 0, 1, 0, 1, 0, 0, 0}).find("size"), std::string::npos);
  EXPECT_NE(problem("cylinder", {1, 2, 3, 1, 2, 3, 1}).find("same point"), std::string::npos);
  EXPECT_EQ(problem("capsule", {1, 2, 3, 1, 2, 3, 1}), "");
  EXPECT_NE(problem("mesh", {0, 0, 0, 0, 0, 0}).find("no triangles"), std::string::npos);
  const TriangleMesh empty;
  EXPECT_NE(makeShape(*findSceneShape("mesh"), std::vector<double>(6), &empty).problem.find("no triangles"),
            std::string::npos);
}

TEST(SceneShapes, AMeshStandsAndTurnsAsABoxDoes) {
  const TriangleMesh mesh = testing::boxMesh({0.1, 0.2, 1});
  const std::vector<double> pose{0.3, -0.2, 0.5, 0.4, -0.7, 1.1};
  const auto made = makeShape(*findSceneShape("mesh"), pose, &mesh);
  const auto box = testing::shape("box", {0.3, -0.2, 0.5, 0.2, 0.4, 2, 0.4, -0.7, 1.1});
  std::mt19937_64 generator(9);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d p = testing::uniformVector(generator, -2, 2);
    EXPECT_NEAR(made.shape->pointDistance(p), box->pointDistance(p), 1e-12);
  }
}

TEST(SceneShapes, BoxTurnsAboutFixedAxes) {
  // A roll and a yaw of a quarter turn each make the box's long z edge parallel to the world's x axis.
  const double quarter = std::numbers::pi / 2;
  const auto box = testing::shape("box", {0, 0, 0, 0.2, 0.4, 2, quarter, 0, quarter});
  EXPECT_NEAR(box->pointDistance({1.5, 0, 0}), 0.5, 1e-12);
  EXPECT_NEAR(box->pointDistance({0, 1, 0}), 0.9, 1e-12);
  EXPECT_NEAR(box->pointDistance({0, 0, 1}), 0.8, 1e-12);
}

}  // namespace
}  // namespace tubeplan::planner
