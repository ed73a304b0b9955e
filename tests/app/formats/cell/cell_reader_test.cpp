#include "app/formats/cell/cell_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "app/formats/cell/cell_writer.hpp"
#include "tests/app/test_files.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

class CellReader : public FolderTest {
 protected:
  /// Writes the mock-up cell with one piece of text changed, and a copy of its arm to the same folder; returns the
  /// path.
  std::string mockupWith(const std::string& from, const std::string& to) const {
    std::filesystem::copy_file(shippedCells() / "cobra-arm.yaml", folder / "cobra-arm.yaml",
                               std::filesystem::copy_options::overwrite_existing);
    return write("cell.yaml", changed(contentOf(shippedCells() / "mockup.yaml"), from, to));
  }

  std::string refusal(const std::string& from, const std::string& to) const {
    return messageOf([&] { (void)readCell(mockupWith(from, to)); });
  }
};

TEST_F(CellReader, readsTheMockUp) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  EXPECT_EQ(cell.name, "cobra-mockup");
  ASSERT_TRUE(cell.sheet.has_value());
  EXPECT_EQ(cell.sheet->tubes.size(), 4674u);
  ASSERT_TRUE(cell.tool.has_value());
  EXPECT_DOUBLE_EQ(cell.tool->steps.at(2).tolerance, 0.010 * kInch);
  EXPECT_FALSE(cell.base_known);
  EXPECT_TRUE(cell.X_WB.translation().isApprox(Eigen::Vector3d(0, 43, -44) * kInch));
  EXPECT_TRUE((cell.X_WB.linear() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY()));
  EXPECT_EQ(cell.scene.obstacles.size(), 5u);
  EXPECT_EQ(cell.scene.bodies.size(), 6u);
  EXPECT_EQ(cell.scene.links.size(), 6u);
  EXPECT_EQ(cell.scene.bodies.back().frame_index, 5);
  EXPECT_DOUBLE_EQ(cell.scene.clearance, 0.25 * kInch);
}

TEST_F(CellReader, takesTheToolAxisFromTheTipsBody) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  const Eigen::Vector3d along = Eigen::Vector3d(16.2493 - 16.25, 7.6, 0).normalized();
  EXPECT_TRUE(cell.arm.tool_axis_L.isApprox(along, 1e-12));
}

TEST_F(CellReader, readsEveryShippedCell) {
  for (const char* name : {"bench.yaml", "bowl.yaml", "mockup-true.yaml"})
    EXPECT_FALSE(readCell((shippedCells() / name).string()).arm.rows.empty()) << name;
  EXPECT_EQ(readCell((shippedCells() / "bench.yaml").string()).identify.size(), 6u);
}

TEST_F(CellReader, readsAnInlineArmAndAHoleMap) {
  write("holes.csv", "row,column,x_in,y_in,state\n1,1,0,3,open\n1,2,1,3,plugged\n2,1,0,4,open\n");
  const std::string cell_path =
      write("cell.yaml",
            "arm:\n  units: {length: in, angle: deg, force: lbf}\n  links:\n"
            "    - {name: one, dh: {alpha: 0, a: 0, d: 1}, joint: {name: q, type: revolute}}\n"
            "  tool: {tip: [1, 0, 0]}\nbase: {position: [0, 0, 0], rpy: [0, 0, 0], known: true}\n"
            "tubesheet: {map: holes.csv, pitch: 1, hole_diameter: 0.5, leg: hot}\n");
  const Cell cell = readCell(cell_path);
  EXPECT_EQ(cell.arm_path, cell_path);
  ASSERT_TRUE(cell.sheet.has_value());
  ASSERT_EQ(cell.sheet->tubes.size(), 3u);
  EXPECT_EQ(cell.sheet->find(1, 2)->state, tubesheets::TubeState::kPlugged);
}

/// A cell of an arm with one joint, below a sheet that is read from a hole map.
class CellOverMap : public CellReader {
 protected:
  [[nodiscard]] Cell cellOverMap(const std::string& map) const {
    (void)write("holes.csv", map);
    return readCell(write("cell.yaml",
                          "arm:\n  units: {length: in, angle: deg, force: lbf}\n  links:\n"
                          "    - {name: one, dh: {alpha: 0, a: 0, d: 1}, joint: {name: q, type: revolute}}\n"
                          "  tool: {tip: [1, 0, 0]}\nbase: {position: [0, 0, 0], rpy: [0, 0, 0], known: true}\n"
                          "tubesheet: {map: holes.csv, pitch: 1, hole_diameter: 0.5, leg: hot}\n"));
  }
};

TEST_F(CellOverMap, warnsOfAHoleOfAMapThatLiesOffItsLattice) {
  std::string map = "row,column,x_mm,y_mm\n";
  for (int row = 1; row <= 5; ++row)
    for (int column = 1; column <= 5; ++column)
      map +=
          fmt::format("{},{},{},{}\n", row, column, 25.4 * column + (row == 3 && column == 2 ? 7.62 : 0), 25.4 * row);
  const Cell cell = cellOverMap(map);
  const auto isOfMap = [](const std::string& warning) { return warning.starts_with("hole map"); };
  ASSERT_EQ(std::ranges::count_if(cell.warnings, isOfMap), 1);
  expectSays(*std::ranges::find_if(cell.warnings, isOfMap),
             "R3C2 at (2.3, 3) in is 0.3 in off the lattice of the holes about it, which has a place at (2, 3)");
}

TEST_F(CellOverMap, namesTwoHolesOfAMapWhoseNamesAreExchanged) {
  std::string map = "row,column,x_mm,y_mm\n";
  for (int row = 1; row <= 5; ++row)
    for (int column = 1; column <= 9; ++column) {
      const int place = row == 3 && column == 4 ? 5 : row == 3 && column == 5 ? 4 : column;
      map += fmt::format("{},{},{},{}\n", row, column, 25.4 * place, 25.4 * row);
    }
  const Cell cell = cellOverMap(map);
  const std::string all = fmt::format("{}", fmt::join(cell.warnings, "\n"));
  expectSays(all, "R3C4 is not at the position that its row gives for column 4, R3C5 is");
  expectSays(all, "R3C5 is not at the position that its row gives for column 5, R3C4 is");
}

TEST_F(CellReader, readsTheManwayAndKeepsItInTheCellsThatItWrites) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  const std::string text = cellTextWithBase(cell, {cell.X_WB, Matrix6d::Identity(), true}, folder / "cell2.yaml");
  for (const Cell& one : {cell, readCell(write("cell2.yaml", text))}) {
    ASSERT_TRUE(one.sheet && one.sheet->manway);
    EXPECT_TRUE(one.sheet->manway->centre.isApprox(Eigen::Vector3d(-33.1, 33.1, -42.2) * kInch));
    EXPECT_DOUBLE_EQ(one.sheet->manway->diameter, 16 * kInch);
  }
  const std::string line = "  manway: {center: [-33.1, 33.1, -42.2], diameter: 16}";
  EXPECT_FALSE(readCell(mockupWith(line, "  name: nameless  ")).sheet->manway.has_value());
}

TEST_F(CellReader, refusesManwaysThatAreNone) {
  expectSays(refusal("diameter: 16}", "diameter: -16}"), "tubesheet.manway.diameter");
  expectSays(refusal("diameter: 16}", "diameter: .nan}"), "tubesheet.manway.diameter");
  expectSays(refusal("diameter: 16}", "diametre: 16}"), "did you mean 'diameter'?");
  expectSays(refusal(", diameter: 16}", "}"), "diameter");
  expectSays(refusal("33.1, -42.2]", "33.1, 42.2]"), "z below 0");
  expectSays(refusal("33.1, -42.2]", "-33.1, -42.2]"), "y above 0 in the hot leg");
  expectSays(refusal("33.1, -42.2]", "33.1]"), "tubesheet.manway.center");
  expectSays(refusal("33.1, -42.2]", ".nan, -42.2]"), "tubesheet.manway.center");
}

TEST_F(CellReader, refusesWhatItDoesNotKnow) {
  expectSays(refusal("hole_diameter: 0.760", "hole_diametre: 0.760"), "did you mean 'hole_diameter'?");
  expectSays(refusal("type: square", "type: sqare"), "did you mean 'square'?");
  expectSays(refusal("leg: hot", "leg: warm"), "warm");
  expectSays(refusal("cylinder:", "cone:"), "'cone'");
  expectSays(refusal("sphere:", "ball:"), "'ball'");
  expectSays(refusal("radius: 0.29", "radius: -0.29"), "tool");
  expectSays(refusal("  forearm:    [", "  upperarm:    ["), "'upperarm'");
  expectSays(refusal("allow: [tool-tip]", "allow: [tooltip]"), "tooltip");
  expectSays(refusal("known: false", "known: no"), "true or false");
  expectSays(refusal("cobra-arm.yaml", "cobra-leg.yaml"), "cobra-leg.yaml");
  expectSays(refusal("tolerance: 0.010", "tolerance: 0.070"), "calibration_tool.steps[2].tolerance");
  expectSays(refusal("hole_diameter: 0.760", "hole_diameter: 1.2"), "hole_diameter");
  expectSays(refusal("columns: 114", "columns: 116"), "columns");
  expectSays(refusal("clearance: 0.25", "clearance: -1"), "clearance");
  expectSays(refusal("clearance: 0.25", "clearence: 0.25"), "did you mean 'clearance'?");
  expectSays(refusal("clearance: 0.25", "clearance: 0.25\nidentify: [forearm.joint_stiffness.x]"),
             "forearm.joint_stiffness.x");
}

Eigen::Isometry3d randomPose(std::mt19937_64& random) {
  const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 * 2 - 1; };
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::Quaterniond(next(), next(), next(), next()).normalized().toRotationMatrix();
  X.translation() = Eigen::Vector3d(next(), next(), next());
  return X;
}

// The first example of docs/files.md must be read: two files, indented by four blanks and separated by a blank line.
TEST_F(CellReader, readsTheSmallestFilesOfTheDocument) {
  const std::string text = contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "docs/files.md");
  const std::size_t from = text.find("    units: {length"), to = text.find("`geometry` frees", from);
  ASSERT_NE(to, std::string::npos);
  std::string files[2];
  int file = 0;
  std::istringstream lines(text.substr(from, to - from));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) file = 1;
    if (!line.empty()) files[file] += line.substr(4) + "\n";
  }
  write("arm.yaml", files[0]);
  write("cell.yaml", files[1]);
  const Cell cell = readCell((folder / "cell.yaml").string());
  EXPECT_EQ(cell.arm.jointCount(), 2);
  EXPECT_EQ(cell.identify.size(), 2u);
}

TEST_F(CellReader, readsRowsThatAreRigidInASetUp) {
  const std::string known = "known: false}";
  const auto with = [&](const std::string& setups) { return known + "\nsetups: " + setups; };
  write("mockup.yaml", changed(contentOf(shippedCells() / "mockup.yaml"), known,
                               with("{bench: {rigid: [mezzanine-beam, mezzanine-platform]}}")));
  write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  const Cell cell = readCell((folder / "mockup.yaml").string());
  const auto& mountings = cell.arm.mountings;
  ASSERT_EQ(mountings.size(), 1u);
  EXPECT_EQ(mountings[0].setup, "bench");
  EXPECT_EQ(mountings[0].rows, (std::vector<int>{0, 1}));
  expectSays(refusal(known, with("{bench: {rigid: [mezzanine-beem]}}")), "did you mean 'mezzanine-beam'?");
  expectSays(refusal(known, with("{bench: {stiff: [mezzanine-beam]}}")), "'stiff'");
  expectSays(refusal(known, with("[bench]")), "SETUP: {rigid: [rows]}");
}

TEST_F(CellReader, writesTheBaseBack) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  std::mt19937_64 random(11);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 20; ++i) poses.push_back(randomPose(random));
  poses.push_back(Eigen::Isometry3d(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX())));
  poses.push_back(Eigen::Isometry3d(Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitY())));
  for (const auto& X_WB : poses) {
    const Matrix6d root = Matrix6d::Random();
    const Matrix6d covariance = 1e-8 * root * root.transpose();
    // The cell is written for another folder, so that the path to the arm's file must change.
    const std::string text = cellTextWithBase(cell, {X_WB, covariance, true}, folder / "deeper" / "cell2.yaml");
    std::filesystem::create_directories(folder / "deeper");
    const Cell again = readCell(write("deeper/cell2.yaml", text));
    EXPECT_TRUE(again.X_WB.isApprox(X_WB, 1e-11));
    EXPECT_TRUE(again.base_known);
    ASSERT_TRUE(again.base_covariance.has_value());
    EXPECT_TRUE(again.base_covariance->isApprox(covariance, 1e-10));
    expectSays(text, "# allowed: z < 0; only the tip may enter a hole");
  }
}

TEST_F(CellReader, refusesHalfOfAPair) {
  const std::string shipped = contentOf(shippedCells() / "cobra-arm.yaml");
  std::string cell = contentOf(shippedCells() / "bench.yaml");
  TextFile arm{folder / "own-arm.yaml", shipped};
  makePair(cell, arm);
  std::string again = cell;
  TextFile same = arm;
  makePair(again, same);
  EXPECT_EQ(again, cell);
  EXPECT_EQ(same.text, arm.text);
  write("own-arm.yaml", arm.text);
  const std::string path = write("own.yaml", cell);
  EXPECT_EQ(readCell(path).arm_source.text, arm.text);
  // Editing a file by hand keeps its pair identifier, so the files are still accepted as a pair.
  write("own-arm.yaml", changed(arm.text, "name: ", "name: other-") + "# changed\n");
  EXPECT_EQ(readCell(path).arm.name.substr(0, 6), "other-");
  for (const std::string& other : {shipped, changed(arm.text, "pair: \"", "pair: \"0")}) {
    write("own-arm.yaml", other);
    const std::string message = messageOf([&] { (void)readCell(path); });
    expectSays(message, "pair");
    expectSays(message, "the arm file that was written with this cell");
  }
  write("own.yaml", contentOf(shippedCells() / "bench.yaml"));
  write("cobra-arm.yaml", arm.text);
  EXPECT_NO_THROW((void)readCell(path)) << "an arm of a pair serves cells that name no pair";
}

TEST_F(CellReader, readsItsOwnCovarianceAndNoOther) {
  const std::string base = "base: {position: [0, 43.0, -44.0], rpy: [0, 0, -90], known: false";
  expectSays(refusal(base, base + ", covariance: [[1, 2], [3, 4]]"), "six lists");
  expectSays(
      refusal(
          base,
          base + ", covariance: [[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,5,1]]"),
      "not symmetric");
  expectSays(
      refusal(
          base,
          base + ", covariance: [[1,2,0,0,0,0],[2,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]"),
      "negative variance");
}

}  // namespace
}  // namespace tubeplan::app
