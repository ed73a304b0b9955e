// The program refuses wrong command lines and inputs with exit code 2 and a message of one line.
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

class Program : public ProgramTest {
 protected:
  /// Expects that the command is refused as bad input: exit code 2, one line of error with all of `words`, nothing on
  /// standard output, and no new file.
  void expectRefused(const std::string& arguments, const std::vector<std::string>& words) const {
    const auto files_before = std::distance(fs::recursive_directory_iterator(folder), {});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& word : words) expectSays(outcome.err, word);
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder), {}), files_before) << arguments;
  }

  /// Writes the mock-up cell and its arm, with one piece of text changed in `file`.
  void writeMockup(const std::string& file, const std::string& from, const std::string& to) const {
    for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) {
      const std::string text = contentOf(shippedCells() / name);
      write(name, file == name ? changed(text, from, to) : text);
    }
  }
};

TEST_F(Program, mapsTheMockUp) {
  const Outcome outcome = run("map '" + (shippedCells() / "mockup.yaml").string() + "' --json - --csv holes.csv");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["holes"], 4674);
  EXPECT_EQ(json["rows"], 49);
  EXPECT_EQ(json["columns"], 114);
  EXPECT_EQ(json["units"]["length"], "in");
  const std::string csv = contentOf(folder / "holes.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "row,column,x_in,y_in,state");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4675);
}

TEST_F(Program, refusesAnOptionOfAnotherAction) {
  const std::string arm = shipped("cobra-arm.yaml");
  expectRefused("arm show " + arm + " --cell x.yaml", {"--cell", "`arm import`, not of `arm show`"});
  expectRefused("arm import " + arm + " --svg x.svg", {"--svg", "`arm show`, not of `arm import`"});
  expectRefused("arm show " + arm + " --out x.yaml", {"--out", "`arm import` or `arm export`"});
  expectRefused("job status a.job --csv x.csv", {"--csv", "`job log` or `job export`, not of `job status`"});
}

TEST_F(Program, printsFiguresInEveryFormat) {
  const std::string map = "map " + shipped("mockup.yaml");
  for (const char* words : {" --format json", " --json -", " --json - --format json"})
    EXPECT_EQ(nlohmann::json::parse(run(map + words).out)["holes"], 4674) << words;
  for (const auto& [format, row] : {std::pair("csv", "\npitch,pitch,1.0625,in,\n"),
                                    std::pair("markdown", "\n| pitch | pitch | 1.0625 | in |  |\n")}) {
    const Outcome outcome = run(map + " --json beside.json --format " + format);
    expectSays(outcome.out, row);
    EXPECT_EQ(nlohmann::json::parse(contentOf(folder / "beside.json"))["holes"], 4674);
    expectRefused(map + " --json - --format " + format, {"--format", format, "standard output"});
  }
  expectSays(run(map).out, "4674 holes");
  expectRefused(map + " --format yaml", {"--format"});
}

TEST_F(Program, helpsWithAnExampleForEachCommand) {
  for (const char* words : {"", "help", "--help"}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0);
    expectSays(outcome.out, "tubeplan map ");
  }
  for (const char* words : {"map --help", "help map"}) expectSays(run(words).out, "Example:");
  EXPECT_EQ(run("--version").out.substr(0, 9), "tubeplan ");
  const std::string cells = run("--cells").out;
  EXPECT_TRUE(std::filesystem::exists(cells.substr(0, cells.find('\n')) + "/outage/job.yaml")) << cells;
}

/// An output that would overwrite an input of the command, or the file of another output option, is refused.
TEST_F(Program, refusesToWriteOverItsInputs) {
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") + " --design bench --readings 24 --seed 3 --out set").exit_code, 0);
  for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  const std::string measurements = "set/measurements.csv", inputs = "bench.yaml " + measurements;
  const std::string before = contentOf(folder / measurements), arm = contentOf(folder / "cobra-arm.yaml");
  expectRefused("identify " + inputs + " --out " + measurements, {"--out", "measurements.csv", "reads"});
  expectRefused("identify " + inputs + " --json ./" + measurements, {"--json", "reads"});
  expectRefused("compare " + inputs + " --report set/../set/measurements.csv", {"--report", "reads"});
  expectRefused("improve " + inputs + " --out cobra-arm.yaml", {"--out", "cobra-arm.yaml", "reads"});
  expectRefused("diagnose " + inputs + " --json bench.yaml", {"--json", "bench.yaml", "reads"});
  expectRefused("diagnose " + inputs + " --json a.txt --report a.txt", {"also writes 'a.txt'"});
  EXPECT_EQ(contentOf(folder / measurements), before);
  EXPECT_EQ(contentOf(folder / "cobra-arm.yaml"), arm);
}

/// `identify` may write its result over the cell that it has read.
TEST_F(Program, writesACellOverItself) {
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") + " --design bench --readings 24 --seed 3 --out set").exit_code, 0);
  for (const char* name : {"bench.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  const Outcome outcome = run("identify bench.yaml set/measurements.csv --out bench.yaml --folds 0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(run("pose bench.yaml --joints 0,30,30,30").exit_code, 0);
}

/// An output cell may replace only a file that is a cell, and its arm file only a file that is not the arm of another
/// cell.
TEST_F(Program, replacesCellsByCellsAndTheirArmsAlone) {
  ASSERT_EQ(run("simulate " + shipped("bench.yaml") + " --design bench --readings 24 --seed 3 --out set").exit_code, 0);
  const std::string inputs = " " + shipped("bench.yaml") + " set/measurements.csv --out ";
  write("other-arm.yaml", "# of another cell\n");
  for (const char* command : {"identify", "improve"}) {
    expectRefused(command + inputs + "other.yaml", {"--out", "other-arm.yaml", "not the arm of"});
    expectRefused(command + inputs + "other-arm.yaml", {"--out", "other-arm.yaml", "is not a cell"});
  }
  expectRefused("add " + shipped("bench.yaml") + " backlash@tool.z --out other-arm.yaml", {"--out", "is not a cell"});
  EXPECT_EQ(contentOf(folder / "other-arm.yaml"), "# of another cell\n");
  for (int times = 0; times < 2; ++times)
    EXPECT_EQ(run("identify" + inputs + "fitted.yaml --folds 0").exit_code, 0) << "its own it replaces";
}

TEST_F(Program, refusesZonesOfOtherTubesAndFoldersWithoutAName) {
  expectRefused("plan " + shipped("mockup.yaml") + " --tubes R10C20,R10C22 --first R30 --out plan", {"--first", "R30"});
  expectRefused("plan " + shipped("mockup.yaml") + " --tubes R10C20 --out ''", {"--out", "folder"});
}

/// Every command that takes a work list refuses a --column with an unknown column or quantity, or without a work list.
TEST_F(Program, refusesColumnsThatAWorkListHasNot) {
  (void)write("list.csv", "Reihe,Spalte\n20,40\n22,44\n");
  const std::string mockup = shipped("mockup.yaml");
  for (const std::string& command :
       {"plan " + mockup + " --out plan", "touches " + mockup, "sensitivity " + mockup,
        "score " + mockup + " --truth " + shipped("mockup-true.yaml"), "campaign " + mockup + " --runs 2"}) {
    expectRefused(command + " --tubes list.csv --column row=Reihen --column column=Spalte",
                  {"--column", "'Reihen'", "did you mean 'Reihe'?"});
    expectRefused(command + " --tubes list.csv --column rows=Reihe", {"--column", "'rows'"});
    expectRefused(command + " --tubes list.csv", {"list.csv"});
    expectRefused(command + " --tubes R20C40 --column row=Reihe", {"--column", "without a work list"});
  }
}

TEST_F(Program, refusesSeedsThatAreNone) {
  for (const char* seed : {"-1", "18446744073709551616", "1.5", "''", "0x10"})
    expectRefused("simulate " + shipped("bench.yaml") + " --design bench --readings 5 --out set --seed " + seed,
                  {"--seed", "a whole number from 0 to 2^64 - 1"});
  EXPECT_EQ(
      run("simulate " + shipped("bench.yaml") + " --design bench --readings 5 --out set --seed 18446744073709551615")
          .exit_code,
      0);
}

TEST_F(Program, refusesCommandLinesThatMakeNoSense) {
  expectRefused("mapp", {"'mapp'", "did you mean 'map'?"});
  expectRefused("map", {"CELL"});
  expectRefused("map a.yaml --frobnicate", {"--frobnicate"});
  expectRefused("--frobnicate", {"--frobnicate"});
}

TEST_F(Program, refusesBadCells) {
  expectRefused("map none.yaml --json -", {"none.yaml", "no such file"});
  write("empty.yaml", "");
  expectRefused("map empty.yaml --json -", {"empty.yaml", "the file is empty"});
  writeMockup("mockup.yaml", "  hole_diameter", "\thole_diameter");
  expectRefused("map mockup.yaml --json -", {"mockup.yaml:9:1", "a tab"});
  writeMockup("mockup.yaml", "  leg: hot\n", "  leg: hot\n  leg: cold\n");
  expectRefused("map mockup.yaml --json -", {"mockup.yaml:11:3", "'leg' occurs a second time"});
  writeMockup("mockup.yaml", "pitch: 1.0625", "pitch: .nan");
  expectRefused("map mockup.yaml --json -", {"tubesheet.layout.pitch", "finite"});
}

TEST_F(Program, refusesBadArms) {
  writeMockup("cobra-arm.yaml", "length: in", "length: inches");
  expectRefused("map mockup.yaml --json -", {"cobra-arm.yaml:10:", "'inches'", "in, mm, cm, m or ft"});
  writeMockup("cobra-arm.yaml", "{z: 5588}", "{z: -5588}");
  expectRefused("map mockup.yaml --json -", {"cobra-arm.yaml:38:", "tool.joint_stiffness.z", "-5588"});
  writeMockup("cobra-arm.yaml", "a: 26.406", "a: 0");
  expectRefused("map mockup.yaml --json -", {"cobra-arm.yaml:", "latch-link.beam", "length zero"});
}

TEST_F(Program, saysWhenItsAnswerIsLost) {
  const std::string cell = (shippedCells() / "mockup.yaml").string();
  const int status = std::system(("'" TUBEPLAN_PROGRAM "' map '" + cell + "' >/dev/full 2>/dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

TEST_F(Program, refusesPosturesAndLoadsTheArmCannotTake) {
  const std::string cell = "'" + (shippedCells() / "bench.yaml").string() + "'";
  expectRefused("pose " + cell + " --joints=1,-2,3,4 --json -", {"--joints (theta2)", "-2 deg", "0 and 180"});
  expectRefused("pose " + cell + " --joints=1,2,3 --json -", {"3 numbers", "4"});
  expectRefused("pose " + cell + " --joints=1,2,nan,4 --json -", {"theta3", "'nan'"});
  expectRefused("pose " + cell + " --joints=1,2,3,4 --load -5 --json -", {"--load", "-5"});
}

TEST_F(Program, refusesTouchesThatCannotPlaceABase) {
  writeMockup("", "", "");
  const std::string header = "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,sigma_in\n";
  const std::string first = "1,touch,R10C20,10,90,-20,5,0.01\n", third = "3,touch,R20C60,12,92,-22,7,0.01\n";
  write("twice.csv", header + first + "2,touch,R10C20,11,91,-21,6,0.01\n" + third);
  expectRefused("calibrate mockup.yaml twice.csv --out cell2.yaml", {"twice.csv", "R10C20", "twice"});
  write("two.csv", header + first + third);
  expectRefused("calibrate mockup.yaml two.csv --out cell2.yaml", {"two.csv", "at least three"});
  write("nowhere.csv", header + first + "2,touch,R99C20,11,91,-21,6,0.01\n" + third);
  expectRefused("calibrate mockup.yaml nowhere.csv --out cell2.yaml", {"nowhere.csv:3", "R99C20"});
}

TEST_F(Program, refusesTubesThatAreNotThereAndFoldersThatCannotBe) {
  writeMockup("", "", "");
  write("file", "x");
  expectRefused("plan mockup.yaml --tubes R99C1 --out result", {"R99C1 is not on this sheet"});
  expectRefused("plan mockup.yaml --tubes R1C57 --out file", {"--out", "a file, not a folder"});
  expectRefused("plan mockup.yaml --tubes R1C57 --out /proc/none", {"--out"});
}

TEST_F(Program, refusesPlacesThatCannotBeWritten) {
  writeMockup("", "", "");
  write("file", "x");
  expectRefused("map mockup.yaml --csv file/holes.csv", {"--csv", "file"});
  expectRefused("map mockup.yaml --json /proc/none/x.json", {"--json"});
  expectRefused("map mockup.yaml --csv good.csv --json /proc/none/x.json", {"--json"});
}

}  // namespace
}  // namespace tubeplan::app
