#include "app/formats/cell/command_inputs.hpp"

#include <nlohmann/json.hpp>
#include <numbers>

#include "app/commands/figures_target.hpp"
#include "app/documents/figures.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/units_json.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

class CommandInputs : public FolderTest {
 protected:
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());

  [[nodiscard]] std::string jointsRefusal(const std::string& text) const {
    return messageOf([&] { (void)parseJoints(text, cell.arm, cell.units, "--joints"); });
  }
  [[nodiscard]] std::string tubesRefusal(const std::string& text) const {
    return messageOf([&] { (void)readTubes(text, *cell.sheet); });
  }
};

TEST_F(CommandInputs, readJointsInTheCellsUnit) {
  const Eigen::VectorXd q = parseJoints("-36.688, 46.138,-35.856,1e1", cell.arm, cell.units, "--joints");
  ASSERT_EQ(q.size(), 4);
  EXPECT_DOUBLE_EQ(q[0], -36.688 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(q[3], 10 * std::numbers::pi / 180);
  EXPECT_NO_THROW((void)parseJoints("175,180,-155,-135", cell.arm, cell.units, "--joints"));
}

TEST_F(CommandInputs, refuseOtherJoints) {
  expectSays(jointsRefusal("1,2,3"), "found 3 numbers, expected 4");
  expectSays(jointsRefusal(""), "--joints");
  expectSays(jointsRefusal("1,2,3,x"), "'x'");
  expectSays(jointsRefusal("1,2,3,nan"), "--joints (theta4)");
  expectSays(jointsRefusal("1,-2,3,4"), "limits, 0 and 180");
}

TEST_F(CommandInputs, refuseImpossibleLoads) {
  EXPECT_NEAR(parseLoad(30, cell.units, "--load"), 133.44664845781, 1e-9);
  EXPECT_THROW((void)parseLoad(-1, cell.units, "--load"), InputError);
  EXPECT_THROW((void)parseLoad(std::nan(""), cell.units, "--load"), InputError);
}

TEST_F(CommandInputs, readTubesFromWordsAndFiles) {
  EXPECT_EQ(readTubes("spread:60", *cell.sheet).tube_indices.size(), 60u);
  EXPECT_EQ(readTubes(write("list.csv", "row,column\n1,57\n10,20\n"), *cell.sheet).tube_indices.size(), 2u);
  expectSays(tubesRefusal("R60C3"), "R60C3");
  EXPECT_EQ(readTubes(write("twice.csv", "row,column\n1,57\n1,57\n"), *cell.sheet).tube_indices.size(), 1u);
  expectSays(tubesRefusal(write("wrong.csv", "row,column\n1,57\n1,x\n")), "wrong.csv:3");
  expectSays(tubesRefusal((folder / "none.csv").string()), "no such file");
}

TEST_F(CommandInputs, readWorkListsByChosenColumns) {
  const std::string list = write("reihen.csv", "Reihe;Spalte;Dauer\n1;57;20\n10;20;\n");
  const std::string zone = (folder / "zone.csv").string();
  const std::vector<std::string> columns{"row=Reihe", "column=" + list + ":Spalte", "dwell_s=Dauer"};
  expectSays(tubesRefusal(list), "reihen.csv");
  const auto found = readTubes(list, *cell.sheet, columns);
  EXPECT_EQ(found.tube_indices.size(), 2u);
  EXPECT_EQ(found.dwell.size(), 1u);
  std::vector<std::string> with_other_list = columns;
  with_other_list.push_back("row=" + zone + ":Zeile");
  EXPECT_EQ(readTubes(list, *cell.sheet, with_other_list).tube_indices, found.tube_indices)
      << "another list's is left out";
  for (const char* wrong : {"row=Reihen", "rows=Reihe", "Reihe", "dwell=Dauer", "row="})
    expectSays(messageOf([&] { (void)readTubes(list, *cell.sheet, {wrong, "column=Spalte"}); }), "--column");
}

TEST_F(CommandInputs, refuseColumnsWithoutAWorkList) {
  EXPECT_NO_THROW(requireWorkList({}, {"all"}));
  EXPECT_NO_THROW(requireWorkList({"row=Reihe"}, {"all", "zone.csv"}));
  for (const char* request : {"all", "R10C20", ""})
    expectSays(messageOf([&] { requireWorkList({"row=Reihe"}, {request}); }), "--column");
}

TEST_F(CommandInputs, writeJsonWithUnits) {
  const nlohmann::json json{{"units", unitsJson(cell.units)},
                            {"p", vectorJson(Eigen::Vector3d(0.0254, 0, -0.0127), cell.units, dimension::kLength)}};
  EXPECT_EQ(json["units"]["length"], "in");
  EXPECT_EQ(json["p"], nlohmann::json({1.0, 0.0, -0.5}));
  writeFigures({(folder / "out.json").string()}, json);
  nlohmann::json written = nlohmann::json::parse(contentOf(folder / "out.json"));
  EXPECT_TRUE(written.contains("version"));
  written.erase("version");
  EXPECT_EQ(written, json);
}

}  // namespace
}  // namespace tubeplan::app
