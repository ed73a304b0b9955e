// Tests of work lists as tables: tables that are accepted, and tables that are refused with the line number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/tubesheets/example_sheets.hpp"
#include "tubesheets/hole_map_csv.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::tubesheets {
namespace {

Sheet smallSheet(Leg leg = Leg::kHot) {
  SheetDescription description = smallDescription();
  description.leg = leg;
  return makeSheet(description);
}

TEST(WorkListCsv, SelectsInSheetOrder) {
  const Sheet sheet = smallSheet();
  const WorkList list = parseWorkListCsv("priority,row,column,comment\n1,4,4,\"first, please\"\n2,1,1,\n9,2,3,late\n");
  ASSERT_EQ(list.status, TubeTextStatus::kRead) << list.problem->sentence();
  const Selection selection = selectTubes(sheet, list);
  ASSERT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason;
  EXPECT_EQ(selection.tube_indices,
            (std::vector<int>{*sheet.indexOf(1, 1), *sheet.indexOf(2, 3), *sheet.indexOf(4, 4)}));
}

TEST(WorkListCsv, AHoleMapIsAWorkList) {
  const Sheet sheet = smallSheet();
  EXPECT_EQ(selectTubes(sheet, parseWorkListCsv(formatHoleMap(sheet))).tube_indices.size(), sheet.tubes.size());
}

TEST(WorkListCsv, AcceptsItsOwnLegAndSheet) {
  const Sheet sheet = smallSheet(Leg::kCold);
  const WorkList list = parseWorkListCsv("row,column,leg,sheet\n1,1,CL," + sheet.fingerprint() + "\n1,2,cold," +
                                         sheet.fingerprint() + "\n");
  EXPECT_EQ(selectTubes(sheet, list).status, SelectionStatus::kSelected);
}

TEST(WorkListCsv, RefusesAHotLegListOnTheColdLeg) {
  const WorkList list = parseWorkListCsv("row,column,leg\n1,1,hot\n");
  EXPECT_EQ(selectTubes(smallSheet(Leg::kHot), list).status, SelectionStatus::kSelected);
  const Selection selection = selectTubes(smallSheet(Leg::kCold), list);
  EXPECT_EQ(selection.status, SelectionStatus::kRefused);
  EXPECT_EQ(selection.reason, "line 2: this list is for the hot leg, but the sheet is cold");
}

TEST(WorkListCsv, RefusesAnotherSheetsFingerprint) {
  const WorkList list = parseWorkListCsv("row,column,sheet\n1,1," + smallSheet(Leg::kCold).fingerprint() + "\n");
  const Selection selection = selectTubes(smallSheet(Leg::kHot), list);
  EXPECT_EQ(selection.status, SelectionStatus::kRefused);
  EXPECT_NE(selection.reason.find("but this sheet is " + smallSheet().fingerprint()), std::string::npos)
      << selection.reason;
}

TEST(WorkListCsv, StatesDistancesInItsOwnUnit) {
  const Sheet sheet = smallSheet();
  const Tube& tube = sheet.tubes.front();
  for (const LengthUnit& unit : lengthUnits()) {
    const WorkList list =
        parseWorkListCsv(fmt::format("row,column,x_{},y_{}\n{},{},{},{}\n", unit.suffix, unit.suffix, tube.row,
                                     tube.column, tube.x / unit.metres + 12, tube.y / unit.metres - 5));
    const Selection selection = selectTubes(sheet, list);
    if (selection.status == SelectionStatus::kSelected) ADD_FAILURE() << unit.suffix;
    EXPECT_NE(selection.reason.find(fmt::format("which is 13 {} away", unit.suffix)), std::string::npos)
        << selection.reason;
  }
}

TEST(WorkListCsv, RefusesATubeThatIsNotThere) {
  const Selection selection = selectTubes(smallSheet(), parseWorkListCsv("row,column\n1,1\n60,3\n"));
  EXPECT_EQ(selection.status, SelectionStatus::kRefused);
  EXPECT_EQ(selection.reason, "line 3: R60C3 is not on this sheet: rows 1 to 4, columns 1 to 8");
}

TEST(WorkListCsv, RefusesAllTubesThatAreNotThereAtOnce) {
  std::string text = "row,column\n1,1\n";
  for (int column = 101; column <= 107; ++column) text += "2," + std::to_string(column) + "\n";
  const Selection selection = selectTubes(smallSheet(), parseWorkListCsv(text));
  EXPECT_EQ(selection.status, SelectionStatus::kRefused);
  for (const char* part : {"7 tubes", "R2C101 (line 3)", "R2C105 (line 7)", "...", "row 2 has columns 1 to 8"})
    EXPECT_NE(selection.reason.find(part), std::string::npos) << part << " in " << selection.reason;
  EXPECT_EQ(selection.reason.find("R2C106"), std::string::npos) << selection.reason;
}

TEST(WorkListCsv, RefusesAListThatWasNeverReadOrRefused) {
  EXPECT_EQ(selectTubes(smallSheet(), WorkList{}).status, SelectionStatus::kRefused);
  const Selection selection = selectTubes(smallSheet(), parseWorkListCsv("row,column\n1,x\n"));
  EXPECT_EQ(selection.status, SelectionStatus::kRefused);
  EXPECT_NE(selection.reason.find("line 2"), std::string::npos) << selection.reason;
}

struct BadList {
  std::string name;
  std::string text;
  int line;
  std::string found;
};

void PrintTo(const BadList& list, std::ostream* out) { *out << list.name; }

class RefusedWorkList : public testing::TestWithParam<BadList> {};

TEST_P(RefusedWorkList, SaysWhereAndWhat) {
  const WorkList list = parseWorkListCsv(GetParam().text);
  ASSERT_EQ(list.status, TubeTextStatus::kRefused);
  ASSERT_TRUE(list.problem.has_value());
  EXPECT_EQ(list.problem->line, GetParam().line) << list.problem->sentence();
  EXPECT_NE(list.problem->sentence().find(GetParam().found), std::string::npos) << list.problem->sentence();
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedWorkList,
    testing::Values(
        BadList{"Empty", "", 0, "no header line"}, BadList{"OnlyHeader", "row,column\n", 1, "no tubes"},
        BadList{"NoHeader", "1,1\n2,2\n", 1, "add a header line"}, BadList{"NoColumn", "row\n1\n", 1, "\"column\""},
        BadList{"UnknownColumn", "row,column,legg\n1,1,hot\n", 1, "\"legg\""},
        BadList{"TwoStates", "row,column,state\n1,1,plugged\n2,2,\n1,1,SLV\n", 4, "plugged, as on line 2"},
        BadList{"TwoStays", "row,column,dwell_s\n1,1,5\n1,1,6\n", 3, "5 s, as on line 2"},
        BadList{"DoneAndNot", "row,column,status\n1,1,done\n1,1,\n", 3, "done, as on line 2"},
        BadList{"TwoStatesInARow", "row,column,state,code\n1,1,PLG,SLV\n", 2, "plugged, as in the column beside it"},
        BadList{"UnknownState", "row,column,status\n1,1,XYZ\n", 2, "\"XYZ\""},
        BadList{"ColumnTwice", "row,column,row\n1,1,1\n", 1, "\"row\" occurs twice"},
        BadList{"TwoNamesOfOneColumn", "Row,Col,Column\n1,1,1\n", 1, "\"Col\" and \"Column\""},
        BadList{"NoteTwice", "row,column,ind,volts,volts\n1,1,,,\n", 1, "\"volts\" occurs twice"},
        BadList{"NameAndNumbersDiffer", "tube,row,column\nR1C2,1,3\n", 2, "column 3"},
        BadList{"NameIsANumber", "tube\n34.12\n", 2, "\"34.12\""},
        BadList{"NameIsARange", "tube\nR1-3\n", 2, "\"R1-3\""},
        BadList{"CommasBelowSemicolons", "row;column\n1;1\n1,2\n", 3, "separated by commas"},
        BadList{"SemicolonsBelowCommas", "row,column\n1;1\n", 2, "separated by semicolons"},
        BadList{"Longer", "row,column\n1,1,1\n", 2, "3 fields"},
        BadList{"Thousands", "row;column;x_mm\n1;1;1.190\n1;2;12,5\n", 2, "\"1.190\""},
        BadList{"NoNameForTubes", "a;b\n1;1\n", 1, "\"tube\""}, BadList{"NaN", "row,column\n1,nan\n", 2, "\"nan\""},
        BadList{"Huge", "row,column\n1,1000000\n", 2, "100000"}, BadList{"Junk", "row,column\nR1C1,\n", 2, "\"R1C1\""},
        BadList{"UnknownLeg", "row,column,leg\n1,1,warm\n", 2, "\"warm\""},
        BadList{"TwoLegs", "row,column,leg\n1,1,hot\n1,2,cold\n", 3, "one list for each leg"},
        BadList{"LegLeftOut", "row,column,leg\n1,1,hot\n1,2,\n", 3, "no leg"},
        BadList{"TwoSheets", "row,column,sheet\n1,1,a\n1,2,b\n", 3, "one list for each sheet"},
        BadList{"MissingField", "row,column\n1\n", 2, "1 fields"}),
    [](const auto& sheet) { return sheet.param.name; });

TEST(WorkListCsv, RefusesCoordinatesOfAnotherHole) {
  const Sheet sheet = smallSheet();
  const Tube& tube = *sheet.find(2, 3);
  const auto select = [&](double x, double y) {
    return selectTubes(sheet, parseWorkListCsv("row,column,x_mm,y_mm\n2,3," + std::to_string(1000 * x) + "," +
                                               std::to_string(1000 * y) + "\n"));
  };
  EXPECT_EQ(select(tube.x, tube.y).status, SelectionStatus::kSelected);
  EXPECT_EQ(select(tube.x + 0.4 * sheet.hole_diameter, tube.y).status, SelectionStatus::kSelected);
  const Selection other = select(sheet.find(2, 4)->x, sheet.find(2, 4)->y);
  EXPECT_EQ(other.status, SelectionStatus::kRefused);
  EXPECT_NE(other.reason.find("line 2"), std::string::npos) << other.reason;
  EXPECT_NE(other.reason.find("R2C3"), std::string::npos) << other.reason;
  EXPECT_EQ(select(-tube.x, tube.y).status, SelectionStatus::kRefused) << "seen from the other side";
  EXPECT_EQ(parseWorkListCsv("row,column,x_in\n2,3,abc\n").problem->what, "x_in");
}

TEST(WorkListCsv, RefusesTwoSteamGenerators) {
  EXPECT_EQ(parseWorkListCsv("row,column,sg\n1,1,A\n1,2,A\n").status, TubeTextStatus::kRead);
  EXPECT_EQ(parseWorkListCsv("row,column,sg\n1,1,A\n1,2,B\n").problem->what, "sg");
}

}  // namespace
}  // namespace tubeplan::tubesheets
