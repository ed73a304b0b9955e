// Plans, work lists and paths record their sheet, leg and tubes, and are refused or refuted for any other sheet, leg or
// tube.
#include "app/commands/plan_identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class PlanIdentity : public ProgramTest {
 protected:
  void SetUp() override {
    for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) (void)write(name, contentOf(shippedCells() / name));
    (void)write("cold.yaml", changed(changed(contentOf(folder / "mockup.yaml"), "leg: hot", "leg: cold"),
                                     "[-33.1, 33.1,", "[-33.1, -33.1,"));
    (void)write("above.yaml", changed(contentOf(folder / "mockup.yaml"), "viewed_from: below", "viewed_from: above"));
    const Outcome outcome = run("plan mockup.yaml --tubes R20C40,R22C44,R39C58 --trajectory --out made");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

TEST_F(PlanIdentity, EveryTubeAndPathRowNamesLegRowAndColumn) {
  const json plan = json::parse(contentOf(folder / "made/plan.json"));
  ASSERT_EQ(plan["tubes"].size(), 2u);
  for (const auto& tube : plan["tubes"]) EXPECT_EQ(tube["leg"], "hot");
  EXPECT_EQ(plan["sheet"]["leg"], "hot");
  EXPECT_EQ(plan["sheet"]["viewed_from"], "below");
  std::istringstream path(contentOf(folder / "made/path.csv"));
  std::string line;
  std::getline(path, line);
  EXPECT_EQ(line, "time_s,segment,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,leg,row,column");
  const auto echoOf = [&](std::size_t visit) {
    return ",hot," + plan["tubes"][visit]["row"].dump() + "," + plan["tubes"][visit]["column"].dump();
  };
  int rows = 0;
  for (; std::getline(path, line); ++rows) {
    const int segment = std::stoi(line.substr(line.find(',') + 1));
    EXPECT_TRUE(line.ends_with(echoOf(segment <= 2 ? 0 : 1))) << line;
  }
  EXPECT_GT(rows, 10);
  EXPECT_EQ(run("verify mockup.yaml made").exit_code, 0);
}

/// A work list with unknown headings, read with --column, gives the same plan as a list with known headings.
TEST_F(PlanIdentity, AWorkListIsReadByTheColumnsThatAreNamed) {
  (void)write("known.csv", "row,column,dwell_s,status\n20,40,25,\n22,44,,\n22,45,,plugged\n");
  (void)write("own.csv", "Reihe,Spalte,Dauer,Befund,x\n20,40,25,,1\n22,44,,,2\n22,45,,plugged,3\n");
  (void)write("own-zone.csv", "Zeile,Kolonne\n22,44\n");
  const std::string columns =
      " --column row=Reihe --column column=own.csv:Spalte --column dwell_s=Dauer --column state=Befund";
  const std::string zone = " --first own-zone.csv --column row=own-zone.csv:Zeile --column column=own-zone.csv:Kolonne";
  EXPECT_EQ(run("plan mockup.yaml --tubes own.csv --out guessed").exit_code, 2);
  ASSERT_EQ(run("plan mockup.yaml --tubes known.csv --first R22C44 --out known").exit_code, 0);
  const Outcome own = run("plan mockup.yaml --tubes own.csv --first R22C44 --out own" + columns);
  ASSERT_EQ(own.exit_code, 0) << own.err;
  expectSays(own.out, "1 plugged according to the list left out");
  EXPECT_EQ(contentOf(folder / "own/path.csv"), contentOf(folder / "known/path.csv"));
  const json tubes = json::parse(contentOf(folder / "own/plan.json"))["tubes"];
  EXPECT_EQ(std::ranges::count_if(tubes, [](const json& tube) { return tube.value("dwell_s", 0.) == 25; }), 1);
  (void)write("own.csv", "Reihe,Spalte\n20,40\n22,44\n");
  (void)write("known.csv", "row,column\n20,40\n22,44\n");
  const Outcome zoned = run("plan mockup.yaml --tubes known.csv --out zoned" + zone);
  EXPECT_EQ(zoned.exit_code, 0) << zoned.err;
}

TEST_F(PlanIdentity, ATubeOfDoubtfulStateIsPlannedWhereItIsNamedAndBothAreSaid) {
  (void)write("list.csv", "row,column,state\n20,40,inaccessible\n22,44,\n22,45,plugged\n");
  const Outcome named = run("plan mockup.yaml --tubes list.csv --out named");
  ASSERT_EQ(named.exit_code, 0) << named.err;
  const std::string sentence = "1 inaccessible among the requested tubes (R20C40): included as requested";
  expectSays(named.out, sentence);
  expectSays(named.out, "1 plugged according to the list left out");
  const json plan = json::parse(contentOf(folder / "named/plan.json"));
  EXPECT_EQ(plan["tubes"].size(), 2u);
  EXPECT_EQ(plan["left_out"], "1 plugged according to the list");
  EXPECT_EQ(std::ranges::count(plan["warnings"].get<std::vector<std::string>>(), sentence), 1);
  expectSays(contentOf(folder / "named/report.html"), sentence);
}

TEST_F(PlanIdentity, APlanIsNotWrittenOverItsOwnInputs) {
  std::filesystem::create_directories(folder / "own");
  for (const char* name : {"cobra-arm.yaml", "mockup.yaml"})
    std::filesystem::copy(folder / name, folder / "own" / (std::string(name) == "mockup.yaml" ? "cell.yaml" : name));
  const std::string cell = contentOf(folder / "own/cell.yaml");
  const Outcome outcome = run("plan own/cell.yaml --tubes R20C40 --out own");
  EXPECT_EQ(outcome.exit_code, 2);
  expectSays(outcome.err, "this command reads");
  EXPECT_EQ(contentOf(folder / "own/cell.yaml"), cell);
  // If a plan has no touches, a touches.csv in its folder is not a file of the plan, and is kept.
  std::filesystem::create_directories(folder / "beside");
  (void)write("beside/touches.csv", "mine");
  ASSERT_EQ(run("plan mockup.yaml --tubes R20C40 --out beside").exit_code, 0);
  EXPECT_EQ(contentOf(folder / "beside/touches.csv"), "mine");
}

TEST_F(PlanIdentity, APlanForAnotherBaseIsVerifiedAtItsOwnAndSaysSo) {
  EXPECT_EQ(run("verify mockup.yaml made").out.find("its own base"), std::string::npos);
  const std::string cell = contentOf(folder / "made/cell.yaml");
  const auto at = cell.find("position: [");
  ASSERT_NE(at, std::string::npos);
  std::string moved = cell.substr(0, at) + "position: [1.5, 2.5" + cell.substr(cell.find(',', cell.find(',', at) + 1));
  if (moved.find("known: false") != std::string::npos) moved = changed(moved, "known: false", "known: true");
  (void)write("made/moved.yaml", moved);
  const Outcome verified = run("verify made/moved.yaml made");
  expectSays(verified.out, "warning: the plan is verified at its own base, which is ");
}

TEST_F(PlanIdentity, ThePlanOfOneLegIsRefusedOnTheOther) {
  const Outcome verified = run("verify cold.yaml made");
  EXPECT_EQ(verified.exit_code, 1);
  expectSays(verified.out, "the mirror image of this one, the other leg");
  expectSays(verified.out, "the plan is for the hot leg, the cell's sheet is the cold leg's");
  const Outcome from = run("plan cold.yaml --tubes R20C40 --from made --out cold");
  EXPECT_EQ(from.exit_code, 2);
  expectSays(from.err, "the tube sheet of that plan (fingerprint ");
  const Outcome above = run("verify above.yaml made");
  EXPECT_EQ(above.exit_code, 1);
  expectSays(above.out, "viewed from below, the cell's from above");
}

TEST_F(PlanIdentity, APathRowThatGoesElsewhereIsRefuted) {
  const std::string path = contentOf(folder / "made/path.csv");
  const std::string first = path.find(",hot,20,40\n") < path.find(",hot,22,44\n") ? ",hot,20,40\n" : ",hot,22,44\n";
  (void)write("made/path.csv", changed(path, first, ",cold,20,40\n"));
  const Outcome leg = run("verify mockup.yaml made");
  EXPECT_EQ(leg.exit_code, 1);
  expectSays(leg.out, "path row 1: approaches cold R20C40, but the plan visits hot R");
  (void)write("made/path.csv", changed(path, first, ",hot,20,41\n"));
  EXPECT_EQ(run("verify mockup.yaml made").exit_code, 1);
}

/// A path with one joint value altered by 1e-9 deg is refuted because it differs from plan.json, although its motion is
/// just as safe.
TEST_F(PlanIdentity, AnAlteredRowOfThePathIsRefutedWhereItDoesNoHarm) {
  ASSERT_EQ(run("verify mockup.yaml made").exit_code, 0);
  const std::string path = contentOf(folder / "made/path.csv");
  const std::size_t row = path.find(",travel,"), joint = row + 8;
  ASSERT_NE(row, std::string::npos);
  const std::size_t end = path.find(',', joint);
  const double value = std::stod(path.substr(joint, end - joint));
  (void)write("made/path.csv", path.substr(0, joint) + fmt::format("{}", value + 1e-9) + path.substr(end));
  const Outcome altered = run("verify mockup.yaml made");
  EXPECT_EQ(altered.exit_code, 1);
  expectSays(altered.out, "path.csv differs from the path that plan.json was written with");
  // A path with the same values in another notation is still proved.
  (void)write("made/path.csv", path.substr(0, joint) + fmt::format("{:.17e}", value) + path.substr(end));
  EXPECT_EQ(run("verify mockup.yaml made").exit_code, 0);
}

TEST_F(PlanIdentity, TheWorkListComesBackAsTheSamePlanAndIsRefusedElsewhere) {
  const std::string list = contentOf(folder / "made/worklist.csv");
  expectSays(list, "leg,sheet,row,column,x_in,y_in,visit,outcome\n");
  expectSays(list, "\"unreachable: ");
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 4);
  ASSERT_EQ(run("plan mockup.yaml --tubes made/worklist.csv --out again").exit_code, 0);
  json made = json::parse(contentOf(folder / "made/plan.json")),
       again = json::parse(contentOf(folder / "again/plan.json"));
  EXPECT_EQ(again["inputs"].size(), made["inputs"].size() + 1);  // the work list is an additional input
  made.erase("inputs");
  again.erase("inputs");
  EXPECT_EQ(again, made);
  for (const char* file : {"path.csv", "worklist.csv"})
    EXPECT_EQ(contentOf(folder / "again" / file), contentOf(folder / "made" / file)) << file;
  const Outcome cold = run("plan cold.yaml --tubes made/worklist.csv --out cold");
  EXPECT_EQ(cold.exit_code, 2);
  expectSays(cold.err, "this list is for");
  (void)write("wider.yaml", changed(contentOf(folder / "mockup.yaml"), "first_row: 2.28", "first_row: 2.3"));
  const Outcome wider = run("plan wider.yaml --tubes made/worklist.csv --out wider");
  EXPECT_EQ(wider.exit_code, 2);
  expectSays(wider.err, "this list is for the sheet ");
}

TEST_F(PlanIdentity, AWorkListComesBackWithAllThatItHad) {
  struct Case {
    std::string text, first, row, end;  ///< the list; heading, row start and line end expected in the output
  };
  for (const auto& [text, first, row, end] :
       {Case{"# zone 5\nsg,leg,row,column,zone,tool,priority,comment\nA,HL,20,40,5,P1,7,ask AB\nA,HL,22,44,5,P1,1,\n",
             "sg,leg,row,column,zone,tool,priority,comment,sheet,visit,outcome", "A,HL,20,40,5,P1,7,ask AB,", "\n"},
        Case{"Tube ID;Exam;Volts\r\nR020C040;Bobbin;0,5\r\n22-44;\"a;b\";\r\n22/44;MRPC;\r\n",
             "Tube ID;Exam;Volts;leg;sheet;visit;outcome", "R020C040;Bobbin;0,5;", "\r\n"}}) {
    (void)write("list.csv", text);
    const Outcome outcome = run("plan mockup.yaml --tubes list.csv --out listed");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string out = contentOf(folder / "listed/worklist.csv");
    expectSays(out, first + end);
    expectSays(out, row);
    std::istringstream before(text), after(out);
    for (std::string theirs, ours; std::getline(before, theirs);) {
      ASSERT_TRUE(std::getline(after, ours));
      if (theirs.ends_with('\r')) theirs.pop_back();
      EXPECT_TRUE(ours.starts_with(theirs)) << ours;
    }
    ASSERT_EQ(run("plan mockup.yaml --tubes listed/worklist.csv --out again").exit_code, 0);
    EXPECT_EQ(contentOf(folder / "again/worklist.csv"), out);
  }
}

TEST_F(PlanIdentity, WhatAListHasBesideItsTubesIsSaidOnce) {
  (void)write("list.csv", "Row;Col;Ind;Exam\n20;40;NDD;Bobbin\n22;44;DSI;MRPC\n22;44;DSI;MRPC\n30;50;PLG;\n");
  const Outcome outcome = run("plan mockup.yaml --tubes list.csv --out noted");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expectSays(outcome.out, "not used in planning, but kept: the column Exam");
  expectSays(outcome.out, "visited once: R22C44 (lines 3 and 4)");
  expectSays(outcome.out, "1 plugged according to the list left out");
  expectSays(contentOf(folder / "noted/worklist.csv"), "30;50;PLG;");
  expectSays(contentOf(folder / "noted/worklist.csv"), ";left out: plugged\n");
  (void)write("absent.csv", "row,column\n20,40\n900,1\n901,1\n");
  const Outcome absent = run("plan mockup.yaml --tubes absent.csv --out absent");
  EXPECT_EQ(absent.exit_code, 2);
  expectSays(absent.err, "2 tubes of the list are not on this sheet: R900C1 (line 3), R901C1 (line 4)");
}

TEST_F(PlanIdentity, TheTrajectoryIsThePathInRadians) {
  const json plan = json::parse(contentOf(folder / "made/plan.json"));
  const YamlNode trajectory = parseYaml(contentOf(folder / "made/trajectory.yaml"), "trajectory.yaml");
  EXPECT_EQ(trajectory.at("joint_names").texts(), (std::vector<std::string>{"theta1", "theta2", "theta3", "theta4"}));
  const auto& points = trajectory.at("points").list();
  ASSERT_GT(points.size(), 10u);
  double before = -1;
  for (const auto& point : points) {
    for (const char* key : {"positions", "velocities", "accelerations"}) EXPECT_EQ(point.at(key).list().size(), 4u);
    const auto& at = point.at("time_from_start");
    const double time = at.at("sec").number() + 1e-9 * at.at("nanosec").integer(0, 999'999'999);
    EXPECT_GT(time, before);
    before = time;
  }
  EXPECT_NEAR(before, plan["total_time_s"].get<double>(), 1e-8);
  // At each tube, the trajectory has a point at rest with the joint values of that tube.
  for (const auto& tube : plan["tubes"])
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const YamlNode& point) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double q = tube["joints"][j].get<double>() * std::numbers::pi / 180;
        if (std::abs(point.at("positions").list()[j].number() - q) > 1e-10) return false;
        if (std::abs(point.at("velocities").list()[j].number()) > 0) return false;
      }
      return true;
    }));
  // Unless requested, no trajectory is written, and an earlier trajectory is removed.
  ASSERT_EQ(run("plan mockup.yaml --tubes R20C40,R22C44 --out made").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "made/trajectory.yaml"));
}

TEST(MirroredLeg, TwiceIsTheSheetItself) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  const auto cold = mirroredLeg(*cell.sheet);
  EXPECT_NE(cold.fingerprint(), cell.sheet->fingerprint());
  EXPECT_EQ(mirroredLeg(cold).fingerprint(), cell.sheet->fingerprint());
  EXPECT_EQ(cold.find(20, 40)->x, cell.sheet->find(20, 40)->x);
  EXPECT_EQ(cold.find(20, 40)->y, -cell.sheet->find(20, 40)->y);
}

}  // namespace
}  // namespace tubeplan::app
