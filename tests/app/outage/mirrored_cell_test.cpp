// The cell of the other leg is the mirror image of the first one, for every shape of the scene.
#include "app/formats/cell/mirrored_cell.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/formats/yaml/yaml_edit.hpp"
#include "planner/scene/scene_shapes.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using Eigen::Vector3d;

Vector3d mirrored(const Vector3d& p) { return {p.x(), -p.y(), p.z()}; }

/// Returns numbers for the fields of a shape, all of them different, as the text of a YAML map.
std::string fieldsOf(const planner::ShapeRow& row) {
  std::string text;
  double next = 3;
  for (const planner::ShapeField& field : row.fields) {
    std::string numbers;
    for (int k = 0; k < field.count; ++k) numbers += fmt::format("{}{:.2f}", k == 0 ? "" : ", ", next += 2.37);
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : ", ", field.name, field.count == 1 ? numbers : "[" + numbers + "]");
  }
  return "{" + text + "}";
}

/// Returns the mock-up with one obstacle of the given shape instead of its scene.
std::string mockupWith(const planner::ShapeRow& row) {
  const std::string key(row.key);
  const std::size_t dot = key.find('.');
  const std::string shape = dot == std::string::npos
                                ? fmt::format("{}: {}", key, fieldsOf(row))
                                : fmt::format("{}: {{{}: {}}}", key.substr(0, dot), key.substr(dot + 1), fieldsOf(row));
  return withYamlValue(contentOf(shippedCells() / "mockup.yaml"), "scene",
                       fmt::format("[{{name: obstacle, {}}}]", shape));
}

TEST(MirroredCell, EveryShapeIsMirrored) {
  int shapes = 0;
  for (const planner::ShapeRow& row : planner::sceneShapes()) {
    if (planner::findMeshField(row)) continue;
    SCOPED_TRACE(row.key);
    const Cell cell = parseCell(mockupWith(row), (shippedCells() / "mockup.yaml").string());
    const Cell other = mirroredCell(cell);
    std::srand(7);
    for (int k = 0; k < 200; ++k) {
      const Vector3d p = 1.5 * Vector3d::Random();
      EXPECT_NEAR(cell.scene.obstacles[0].shape->pointDistance(p),
                  other.scene.obstacles[0].shape->pointDistance(mirrored(p)), 1e-9);
    }
    ++shapes;
  }
  EXPECT_GE(shapes, 6);
}

TEST(MirroredCell, TubesKeepTheirNamesOnTheOtherSideOfTheDivider) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string()), other = mirroredCell(cell);
  ASSERT_EQ(other.sheet->tubes.size(), cell.sheet->tubes.size());
  EXPECT_EQ(other.sheet->leg, tubesheets::Leg::kCold);
  for (const auto& tube : cell.sheet->tubes) {
    const auto* end = other.sheet->find(tube.row, tube.column);
    ASSERT_NE(end, nullptr);
    EXPECT_EQ(end->x, tube.x);
    EXPECT_EQ(end->y, -tube.y);
  }
  EXPECT_NEAR((other.X_WB.translation() - mirrored(cell.X_WB.translation())).norm(), 0, 1e-12);
  EXPECT_NE(other.sheet->fingerprint(), cell.sheet->fingerprint());
}

TEST(MirroredCell, TwiceIsTheFirstLeg) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string()), again = mirroredCell(mirroredCell(cell));
  EXPECT_EQ(again.sheet->fingerprint(), cell.sheet->fingerprint());
  EXPECT_TRUE(again.X_WB.isApprox(cell.X_WB, 1e-12));
  EXPECT_FALSE(again.base_known);
  EXPECT_EQ(mirroredCellText(again), mirroredCellText(mirroredCell(mirroredCell(again))));
}

TEST(MirroredCell, WhatBelongsToOneLegIsNotCarriedOver) {
  std::string text = withYamlValue(contentOf(shippedCells() / "mockup.yaml"), "base.known", "true");
  const Cell other = mirroredCell(parseCell(text, (shippedCells() / "mockup.yaml").string()));
  EXPECT_FALSE(other.base_known);
  EXPECT_FALSE(other.park);
}

TEST(MirroredCell, RefusesWhatHasNoMirrorImage) {
  const Cell once_through = readCell((shippedCells() / "sheets/once-through.yaml").string());
  expectSays(messageOf([&] { (void)mirroredCell(once_through); }), "no other leg");
}

}  // namespace
}  // namespace tubeplan::app
