// Tests of cells with meshes in the scene: distances, refusals, writing, planning and verification.
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/checkpoint/plan_key.hpp"
#include "app/workbench/geometry_json.hpp"
#include "tests/app/formats/mesh/mesh_files.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using planner::testing::cylinderMesh;

constexpr const char* kCylinderRow =
    "{name: nozzle-dam, cylinder: {from: [30, 30, -50], to: [30, 30, -44], radius: 6}}";
constexpr const char* kMeshRow = "{name: nozzle-dam, mesh: {file: dam.stl, position: [30, 30, -47]}}";

class MeshCell : public ProgramTest {
 protected:
  /// Writes the mock-up's cell with `row` in place of the obstacle `nozzle-dam`; returns the path.
  std::string writeCell(const std::string& name, const std::string& row) const {
    std::string text = contentOf(shippedCells() / "mockup.yaml");
    text = changed(text, "arm: cobra-arm.yaml", "arm: " + (shippedCells() / "cobra-arm.yaml").string());
    return write(name, changed(text, kCylinderRow, row));
  }
  void writeDam(double unit = 1) const { write("dam.stl", stlBytes(cylinderMesh(6 * unit, 3 * unit, 96))); }

  [[nodiscard]] nlohmann::json planOf(const std::string& folder_name) const {
    return nlohmann::json::parse(contentOf(folder / folder_name / "plan.json"));
  }
};

TEST_F(MeshCell, IsReadInTheCellsUnitOrInItsOwn) {
  writeDam();
  const Cell cell = readCell(writeCell("cell.yaml", kMeshRow));
  ASSERT_EQ(cell.meshes.size(), 1u);
  EXPECT_EQ(cell.meshes[0].key, "scene[4].mesh.file");
  EXPECT_EQ(cell.meshes[0].obstacle, "nozzle-dam");
  EXPECT_TRUE(cell.warnings.empty());
  const auto& bounds = cell.meshes[0].shape->tree().bounds();
  EXPECT_NEAR(bounds.min().z(), -50 * 0.0254, 1e-6);
  EXPECT_NEAR(bounds.max().x(), 36 * 0.0254, 1e-6);
  writeDam(25.4);
  const Cell metric =
      readCell(writeCell("mm.yaml", "{name: nozzle-dam, mesh: {file: dam.stl, unit: mm, position: [30, 30, -47]}}"));
  EXPECT_NEAR((metric.meshes[0].shape->tree().bounds().max() - bounds.max()).norm(), 0, 1e-6);
}

TEST_F(MeshCell, WhatMakesNoSenseIsRefusedWithItsPlace) {
  writeDam();
  const auto message = [&](const std::string& row) {
    const std::string cell = writeCell("cell.yaml", row);
    return messageOf([&] { (void)readCell(cell); });
  };
  expectSays(message("{name: nozzle-dam, mesh: {file: dma.stl}}"), "cell.yaml:21");
  expectSays(message("{name: nozzle-dam, mesh: {file: dma.stl}}"), "no file");
  expectSays(message("{name: nozzle-dam, mesh: {position: [1, 2, 3]}}"), "file");
  expectSays(message("{name: nozzle-dam, mesh: {file: dam.stl, unit: cubit}}"), "unknown unit");
  expectSays(message("{name: nozzle-dam, mesh: {file: dam.stl, scale: 2}}"), "scale");
  writeDam(25.4);
  expectSays(message(kMeshRow), "unit: mm");
  writeDam(0.0254);
  expectSays(message(kMeshRow), "unit:");
  writeDam();
  std::string text = contentOf(writeCell("cell.yaml", kMeshRow));
  text = changed(text, "latch-link: [{capsule: {from: [0, 0, 0], to: [26.4, 0, 0], radius: 2.75}}]",
                 "latch-link: [{mesh: {file: dam.stl}}]");
  const std::string cell = write("cell.yaml", text);
  expectSays(messageOf([&] { (void)readCell(cell); }), "convex");
}

TEST_F(MeshCell, AnOpenOrDistantMeshIsWarnedOf) {
  auto open = cylinderMesh(6, 3, 12);
  open.triangles.pop_back();
  write("dam.stl", stlBytes(open));
  const Cell cell = readCell(writeCell("cell.yaml", kMeshRow));
  ASSERT_EQ(cell.warnings.size(), 1u);
  expectSays(cell.warnings[0], "nozzle-dam");
  expectSays(cell.warnings[0], "a surface: 3 of its edges are open");
  const auto shape = sceneDrawing(cell)["shapes"][4];
  EXPECT_EQ(shape["mesh"]["solid"], false);
  writeDam();
  const Cell distant =
      readCell(writeCell("far.yaml", "{name: nozzle-dam, mesh: {file: dam.stl, position: [900, 30, -47]}}"));
  ASSERT_EQ(distant.warnings.size(), 1u);
  expectSays(distant.warnings[0], "out of the arm's reach");
}

TEST_F(MeshCell, IsDrawnAsABoxAndGivesItsTriangles) {
  writeDam();
  const auto scene = sceneDrawing(readCell(writeCell("cell.yaml", kMeshRow)));
  const auto& shape = scene["shapes"][4];
  EXPECT_EQ(shape["kind"], "box");
  EXPECT_EQ(shape["name"], "nozzle-dam");
  EXPECT_NEAR(shape["center"][2].get<double>(), -47, 1e-5);
  EXPECT_NEAR(shape["size"][0].get<double>(), 12, 1e-5);
  EXPECT_EQ(shape["outline"].size(), 8u * 3);
  EXPECT_EQ(shape["mesh"]["file"], "dam.stl");
  EXPECT_EQ(shape["mesh"]["solid"], true);
  EXPECT_EQ(shape["mesh"]["positions"].size(), 9 * shape["mesh"]["triangles"].get<std::size_t>());
  EXPECT_TRUE(scene["warnings"].empty());
}

TEST_F(MeshCell, WrittenElsewhereTheFileIsStillFound) {
  std::filesystem::create_directories(folder / "deep/er");
  writeDam();
  const Cell cell = readCell(writeCell("cell.yaml", kMeshRow));
  const Cell again = readCell(write("deep/er/cell.yaml", cellTextAt(cell, folder / "deep/er/cell.yaml")));
  EXPECT_EQ(std::filesystem::canonical(again.meshes[0].path), std::filesystem::canonical(folder / "dam.stl"));
  // A copy of the cell in another folder must give the same inputs of a plan, until the content of the mesh file
  // changes.
  const auto question = [](const Cell& c) {
    return partOf(
        planKeyOf({c, workcellOf(c, "ask"), planner::VisitConditions(), "via-point", 0, false, 0, 1, ""}, {1, 2}),
        "arm and scene");
  };
  EXPECT_EQ(question(cell), question(again));
  write("dam.stl", stlBytes(cylinderMesh(5.9, 3, 96)));
  EXPECT_NE(question(cell), question(readCell(cell.path)));
}

TEST_F(MeshCell, IsPlannedRoundAsTheCylinderIs) {
  writeDam();
  writeCell("mesh.yaml", kMeshRow);
  writeCell("cylinder.yaml", kCylinderRow);
  for (const std::string kind : {"mesh", "cylinder"}) {
    const auto planned = run("plan " + kind + ".yaml --tubes spread:12 --seed 1 --out " + kind);
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
  }
  const auto mesh = planOf("mesh"), cylinder = planOf("cylinder");
  ASSERT_EQ(mesh["tubes"].size(), cylinder["tubes"].size());
  EXPECT_EQ(mesh["unreachable"].size(), cylinder["unreachable"].size());
  for (std::size_t k = 0; k < mesh["tubes"].size(); ++k)
    EXPECT_EQ(mesh["tubes"][k]["name"], cylinder["tubes"][k]["name"]);
  EXPECT_NEAR(mesh["travel_time_s"].get<double>(), cylinder["travel_time_s"].get<double>(), 0.5);
  EXPECT_EQ(run("verify mesh.yaml mesh").exit_code, 0);
  EXPECT_EQ(run("verify mesh/cell.yaml mesh").exit_code, 0);
  EXPECT_EQ(run("verify mesh.yaml cylinder").exit_code, 0);
}

TEST_F(MeshCell, InTheWayItIsNamedAsTheCylinderIs) {
  write("dam.stl", stlBytes(cylinderMesh(6, 4, 96)));
  writeCell("mesh.yaml", "{name: nozzle-dam, mesh: {file: dam.stl, position: [0, 30, -8]}}");
  writeCell("cylinder.yaml", "{name: nozzle-dam, cylinder: {from: [0, 30, -12], to: [0, 30, -4], radius: 6}}");
  nlohmann::json plans[2];
  for (int k = 0; k < 2; ++k) {
    const std::string kind = k == 0 ? "mesh" : "cylinder";
    const auto planned =
        run("plan " + kind + ".yaml --tubes R20C57,R26C57-58,R15C30,R27C50,R3C10,R10C95 --seed 1 --out " + kind);
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    plans[k] = planOf(kind);
  }
  ASSERT_GT(plans[1]["unreachable"].size(), 0u);
  ASSERT_EQ(plans[0]["unreachable"].size(), plans[1]["unreachable"].size());
  for (std::size_t k = 0; k < plans[0]["unreachable"].size(); ++k) {
    EXPECT_EQ(plans[0]["unreachable"][k]["row"], plans[1]["unreachable"][k]["row"]);
    EXPECT_EQ(plans[0]["unreachable"][k]["in_the_way"]["other"], "nozzle-dam");
  }
  EXPECT_EQ(plans[0]["tubes"].size(), plans[1]["tubes"].size());
  EXPECT_EQ(run("verify mesh.yaml mesh").exit_code, 0);
}

}  // namespace
}  // namespace tubeplan::app
