// Tests of hole maps and work lists in the formats of other programs: one reader for all, and exact round trips.
#include "tubesheets/tube_table.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "tests/tubesheets/example_sheets.hpp"
#include "tubesheets/hole_map_csv.hpp"
#include "tubesheets/table_text.hpp"
#include "tubesheets/tube_forms.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::tubesheets {
namespace {

Sheet foreignSheet() { return makeSheet(smallDescription()); }

std::vector<std::string> selectedNames(const Sheet& sheet, const Selection& selection) {
  std::vector<std::string> names;
  for (const int index : selection.tube_indices)
    names.push_back(tubeName(sheet.tubes[static_cast<std::size_t>(index)].row,
                             sheet.tubes[static_cast<std::size_t>(index)].column));
  return names;
}

/// Text format of a list: field separator, line ending, and text before the table.
struct Dialect {
  char separator;
  std::string end, before;
};

const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> all{{',', "\n", ""},
                                        {';', "\n", "# SG A, outage 12\n\n"},
                                        {'\t', "\r\n", ""},
                                        {'|', "\n", "Work list 7 of SG A\n"},
                                        {';', "\r\n", "\xEF\xBB\xBF// exported\r\n"}};
  return all;
}

/// The tubes R2C3, R4C4 and again R2C3 in every supported notation: headings, then the fields of each row.
const std::vector<std::vector<std::vector<std::string>>>& nameForms() {
  static const std::vector<std::vector<std::vector<std::string>>> all{
      {{"row", "column"}, {"2", "3"}, {"4", "4"}, {"2", "3"}},
      {{"ROW", "COL"}, {"002", "003"}, {"004", "004"}, {"002", "003"}},
      {{"R", "C"}, {"R2", "C3"}, {"R4", "C4"}, {"R2", "C3"}},
      {{"Row", "Tube"}, {"2", "3"}, {"4", "4"}, {"2", "3"}},
      {{"Row", "Line"}, {"2", "3"}, {"4", "4"}, {"2", "3"}},
      {{"Column", "Row No."}, {"3", "2"}, {"4", "4"}, {"3", "2"}},
      {{"Tube"}, {"R002C003"}, {"R4C4"}, {"r2c3"}},
      {{"Tube ID"}, {"2-3"}, {"4-4"}, {"2-3"}},
      {{"hole"}, {"2/3"}, {"R4 C4"}, {"Row 2 Col 3"}},
      {{"Tube", "Row", "Col"}, {"R2C3", "2", "3"}, {"R4C4", "4", "4"}, {"C3R2", "2", "3"}},
      {{"SG", "Leg", "Row", "Col", "Exam"},
       {"A", "HL", "2", "3", "Bobbin, A-560"},
       {"A", "Hot leg", "4", "4", ""},
       {"A", "H", "2", "3", "MRPC"}},
      {{"row", "column", "ind", "volts"}, {"2", "3", "NDD", ""}, {"4", "4", "DSI", "0.5"}, {"2", "3", "37", "1.2"}},
  };
  return all;
}

std::string written(const std::vector<std::vector<std::string>>& rows, const Dialect& dialect) {
  std::string text = dialect.before;
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += (c > 0 ? std::string(1, dialect.separator) : "") + csvField(row[c], dialect.separator);
    text += dialect.end;
  }
  return text;
}

TEST(TubeTable, AListGivesItsTubesInEveryDialectAndNameForm) {
  const Sheet sheet = foreignSheet();
  for (const auto& form : nameForms())
    for (const auto& dialect : dialects()) {
      const std::string text = written(form, dialect);
      const Selection selection = selectTubes(sheet, parseWorkListCsv(text));
      ASSERT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason << "\n" << text;
      EXPECT_EQ(selectedNames(sheet, selection), (std::vector<std::string>{"R2C3", "R4C4"})) << text;
      ASSERT_FALSE(selection.list->notes.empty());
      EXPECT_NE(selection.list->notes.back().find("R2C3 (lines "), std::string::npos) << selection.list->notes.back();
    }
}

TEST(TubeTable, AColumnOfWhichNothingIsKnownIsNotedOnce) {
  const auto notesOf = [](const std::string& text) { return parseWorkListCsv(text).notes; };
  EXPECT_EQ(notesOf("row,column,exam,probe\n1,1,Bobbin,A\n1,2,Bobbin,A\n"),
            (std::vector<std::string>{"not used in planning, but kept: the columns exam, probe"}));
  EXPECT_EQ(notesOf("row,column,zone,tool,priority,comment\n1,1,,,,\n"), std::vector<std::string>{});
  EXPECT_EQ(notesOf("row,column,code\n1,1,QQQ\n1,2,QQQ\n1,3,NDD\n1,4,37\n"),
            (std::vector<std::string>{"unknown codes, treated as remarks: QQQ (2 rows)"}));
}

TEST(TubeForms, AreReadWhereTheyAreClear) {
  for (const char* text : {"R012C034", "R12C34", "r12c34", "R12 C34", "R12-C34", "R12/C34", "Row 12 Col 34",
                           "ROW12COLUMN34", "C34R12", "R12L34", "R12T34", "12-34", "12/34", "12 - 34", "012-034"}) {
    const auto tube = readTubeForm(text);
    ASSERT_TRUE(tube.has_value()) << text;
    EXPECT_EQ(tube->row, 12) << text;
    EXPECT_EQ(tube->column, 34) << text;
  }
  for (const char* text : {"", "12", "34.12", "12,34", "12 34", "R12", "R12-34", "R12R34", "12-34-56", "R12C", "X12C34",
                           "R0C1", "R12C34x", "-12-34", "R1.5C3", "R12C999999999999"})
    EXPECT_FALSE(readTubeForm(text).has_value()) << text;
}

TEST(TubeCodes, HaveNamesThatStandOnce) {
  std::set<std::string> names;
  for (const TubeCode& code : tubeCodes()) {
    EXPECT_TRUE(names.insert(plainName(code.name)).second) << code.name;
    EXPECT_EQ(findTubeCode(code.name)->words, code.words) << code.name;
  }
  for (const TubeState state : tubeStates()) EXPECT_EQ(findTubeCode(tubeStateName(state))->state, state);
  EXPECT_EQ(findTubeCode("To Plug")->state, TubeState::kToPlug);
  EXPECT_EQ(findTubeCode("plg")->state, TubeState::kPlugged);
  EXPECT_EQ(findTubeCode("PLUGGD"), nullptr);
}

TEST(TubeCodes, SayWhichTubesOfAListAreVisited) {
  const Sheet sheet = foreignSheet();
  for (const char* heading : {"State", "STATUS", "Code", "Ind"})
    for (const TubeCode& code : tubeCodes()) {
      const Selection selection = selectTubes(
          sheet, parseWorkListCsv(std::string("Row;Col;") + heading + "\n1;1;\n2;3;" + std::string(code.name) + "\n"));
      ASSERT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason;
      const bool keeps_tool_out =
          code.use == CodeUse::kState && (code.state == TubeState::kPlugged || code.state == TubeState::kStabilised);
      const bool is_left_out = keeps_tool_out || code.use == CodeUse::kDone;
      EXPECT_EQ(selection.tube_indices.size(), is_left_out ? 1u : 2u) << code.name;
      EXPECT_EQ(selection.left_out.size(), is_left_out ? 1u : 0u) << code.name;
      EXPECT_TRUE(selection.list->notes.empty()) << code.name;
    }
}

/// A table with unknown headings is read if columns are chosen for row and column, or for the tube's name.
TEST(TubeTable, IsReadByColumnsThatAreChosenWhateverTheirHeadings) {
  const auto place = [](TubeColumn column, std::size_t at) { return ChosenTubeColumn{column, at}; };
  const struct {
    const char* text;
    std::vector<ChosenTubeColumn> chosen;
  } rows[] = {
      {"Reihe;Spalte;Dauer\n2;3;30\n4;4;\n",
       {place(TubeColumn::kRow, 0), place(TubeColumn::kColumn, 1), place(TubeColumn::kDwell, 2)}},
      {"3,2,30\n4,4,0\n", {place(TubeColumn::kRow, 1), place(TubeColumn::kColumn, 0), place(TubeColumn::kDwell, 2)}},
      {"Rohr\tHalt\nR2C3\tNDD\nR4C4\tNDD\n", {place(TubeColumn::kTube, 0), place(TubeColumn::kCode, 1)}},
      {"Auftrag 7\nReihe|Spalte|Zone\n2|3|a\n4|4|b\n", {place(TubeColumn::kRow, 0), place(TubeColumn::kColumn, 1)}},
      {"# row,column\n2,3\n4,4\n", {place(TubeColumn::kRow, 0), place(TubeColumn::kColumn, 1)}}};
  const Sheet sheet = foreignSheet();
  for (const auto& [text, chosen] : rows) {
    TextTable table = parseTubeText(text);
    ASSERT_FALSE(table.problem) << table.problem->sentence() << text;
    const WorkList list = readWorkListTable(text, tubeTableOf(std::move(table), chosen));
    ASSERT_EQ(list.status, TubeTextStatus::kRead) << list.problem->sentence() << text;
    const Selection selection = selectTubes(sheet, list);
    EXPECT_EQ(selectedNames(sheet, selection), (std::vector<std::string>{"R2C3", "R4C4"})) << text;
    if (chosen.back().column != TubeColumn::kDwell) continue;
    EXPECT_EQ(list.items[0].dwell, 30) << text;
  }
}

TEST(TubeTable, RefusesColumnsThatAreChosenTwiceOrNameNoTube) {
  const std::string text = "Reihe;Spalte;x;y\n2;3;1;2\n";
  const auto problemOf = [&](const std::vector<ChosenTubeColumn>& chosen) {
    return tubeTableOf(parseTubeText(text), chosen).problem.has_value();
  };
  const ChosenTubeColumn row{TubeColumn::kRow, 0}, column{TubeColumn::kColumn, 1};
  EXPECT_FALSE(problemOf({row, column}));
  EXPECT_FALSE(problemOf({row, column, {TubeColumn::kX, 2, &kInch}, {TubeColumn::kY, 3, &kInch}}));
  EXPECT_TRUE(problemOf({}));
  EXPECT_TRUE(problemOf({row}));
  EXPECT_TRUE(problemOf({row, column, {TubeColumn::kRow, 2}}));
  EXPECT_TRUE(problemOf({row, column, {TubeColumn::kX, 2, &kInch}, {TubeColumn::kY, 3, &kMillimetre}}));
}

TEST(TubeTable, OffersEveryQuantityOnceWithTheNameThatItsHeadingHas) {
  std::set<TubeColumn> seen;
  for (const auto& [column, name, units] : tubeQuantities()) {
    EXPECT_TRUE(seen.insert(column).second) << name;
    const std::string heading = std::string(name) + (units.empty() ? "" : "_" + std::string(units.front()));
    EXPECT_EQ(readTubeHeading(heading).column, column) << heading;
  }
  EXPECT_TRUE(seen.contains(TubeColumn::kTube));
}

TEST(TextTables, StateTheirUnitsInALineOfTheirOwn) {
  for (const char* line : {"Units: mm", "# unit = mm", "// UNITS : mm", "Coordinates in units: mm"})
    EXPECT_EQ(trimBlanks(behindUnits(line)), "mm") << line;
  for (const char* line : {"", "units", "unity: mm", "runit: mm", "mm", "Units mm", "uni"})
    EXPECT_EQ(behindUnits(line), "") << line;
}

TEST(TubeCodes, AreTheStatesOfAMap) {
  const HoleMap map =
      parseHoleMap("Row;Col;X (mm);Y (mm);Status\n1;1;0,5;25,0;PLG\n1;2;30,5;25,0;OBS\n1;3;60,5;25,0;NDD\n");
  ASSERT_EQ(map.status, TubeTextStatus::kRead) << map.problem->sentence();
  EXPECT_EQ(map.tubes[0].state, TubeState::kPlugged);
  EXPECT_EQ(map.tubes[1].state, TubeState::kInaccessible);
  EXPECT_EQ(map.tubes[2].state, TubeState::kOpen);
  EXPECT_NEAR(map.tubes[1].x, 0.0305, 1e-12);
}

TEST(TubeTable, AMapStatesItsUnitInTheHeadingBelowItOrBeforeIt) {
  for (const char* text : {"row,column,x_in,y_in\n1,1,2,3\n", "Row,Col,X (in),Y [inches]\n1,1,2,3\n",
                           "Row;Col;X;Y\n;;in;in\n1;1;2,0;3\n", "// Units: Inches\nRow,Col,X,Y\n1,1,2,3\n",
                           "Units = mm\nRow,Col,X,Y\n1,1,50.8,76.2\n", "# row|col|x_mm|y_mm\n1|1|50,8|76,2\n"}) {
    const HoleMap map = parseHoleMap(text);
    ASSERT_EQ(map.status, TubeTextStatus::kRead) << map.problem->sentence() << "\n" << text;
    EXPECT_NEAR(map.tubes[0].x, 0.0508, 1e-12) << text;
    EXPECT_NEAR(map.tubes[0].y, 0.0762, 1e-12) << text;
  }
  EXPECT_EQ(parseWorkListCsv("row,column,x,y\n1,1,2,3\n").notes.size(), 1u);
}

/// Returns the text without the last `columns` fields of each line.
std::string withoutLast(const std::string& text, char separator, std::size_t columns) {
  std::string out;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string line = text.substr(start, end - start);
    const std::string tail = line.ends_with('\r') ? "\r" : "";
    line.resize(line.size() - tail.size());
    for (std::size_t k = 0; k < columns && line.find(separator) != std::string::npos; ++k)
      line.resize(line.rfind(separator));
    out += line + tail + (end < text.size() ? "\n" : "");
    start = end + 1;
  }
  return out;
}

TEST(TableText, KeepsAllThatWasThereInEveryDialectAndNameForm) {
  for (const auto& form : nameForms())
    for (const auto& dialect : dialects()) {
      if (form.front().size() == 1 && dialect.separator != ',') continue;  // a table with one column has no separator
      const std::string text = written(form, dialect);
      const TubeTable table = parseTubeTable(text);
      ASSERT_FALSE(table.problem) << table.problem->sentence();
      ColumnText visit{"visit", std::nullopt, {}};
      for (const CsvRow& row : table.text.rows) visit.fields.emplace(row.line, std::to_string(row.line));
      const std::string out = withColumns(text, table.text, {visit});
      EXPECT_EQ(withColumns(text, table.text, {}), text);
      EXPECT_EQ(withoutLast(out, dialect.separator, 1), text);
      const TubeTable again = parseTubeTable(out);
      ASSERT_FALSE(again.problem) << again.problem->sentence() << out;
      EXPECT_EQ(again.text.rows.size(), 3u);
      EXPECT_EQ(again.field(again.text.rows[1], TubeColumn::kVisit), std::to_string(again.text.rows[1].line));
      visit.place = again.places.at(TubeColumn::kVisit);
      EXPECT_EQ(withColumns(out, again.text, {visit}), out) << "what says the same stays";
    }
}

TEST(TableText, KeepsUnitsRowsCommentsAndEmptyFieldsBehindTabs) {
  const std::string text = "row\tcolumn\tx\tnote\r\n\t\tmm\t\r\n# zone 1\r\n1\t1\t5,0\t\r\n\r\n1\t2\t\"6,0\"\tlast";
  const TubeTable table = parseTubeTable(text);
  ASSERT_FALSE(table.problem) << table.problem->sentence();
  ASSERT_EQ(table.text.rows.size(), 2u);
  EXPECT_EQ(withColumns(text, table.text, {{"visit", std::nullopt, {{4, "2"}, {6, "1"}}}}),
            "row\tcolumn\tx\tnote\tvisit\r\n\t\tmm\t\t\r\n# zone 1\r\n1\t1\t5,0\t\t2\r\n\r\n1\t2\t\"6,0\"\tlast\t1");
}

/// Returns a cell's sheet made from a hole map, as the reader of cell files makes it.
Sheet sheetOfMap(const std::string& text) {
  auto map = std::make_shared<HoleMap>(parseHoleMap(text));
  EXPECT_EQ(map->status, TubeTextStatus::kRead) << map->problem->sentence();
  SheetDescription description = smallDescription();
  description.layout.type = "map";
  Sheet sheet = makeSheet(description, map->tubes);
  sheet.map = std::move(map);
  return sheet;
}

TEST(FormatHoleMap, GivesAMapOfItsOwnWayBackByteForByte) {
  for (const std::string text : {"row,column,x_in,y_in,state\n1,1,0,1,open\n1,2,1.25,1,plugged\n",
                                 "# drilled 1988\r\nstate,x_in,y_in,zone,row,column,leg\r\nplugged,1.250,1,\"a, "
                                 "b\",1,2,hot\r\n\r\n,0,1,,1,1,hot\r\n"})
    EXPECT_EQ(formatHoleMap(sheetOfMap(text), kInch), text);
}

TEST(FormatHoleMap, WritesStatesForCodesAndConvertsOtherWaysWithAllTheirColumns) {
  EXPECT_EQ(formatHoleMap(sheetOfMap("row,column,x_in,y_in,state,zone\n1,1,0,1,PLG,7\n1,2,1.25,1,,8\n"), kInch),
            "row,column,x_in,y_in,state,zone\n1,1,0,1,plugged,7\n1,2,1.25,1,,8\n");
  EXPECT_EQ(
      formatHoleMap(
          sheetOfMap("// SG A\nCol;Row;X (mm);Y (mm);Status;Heat\n2;1;25,4;25,4;TBP;\"h;2, b\"\n1;1;0;25,4;;h1\n"),
          kInch),
      "# // SG A\nrow,column,x_in,y_in,state,Heat\n1,1,0,1,open,h1\n1,2,1,1,to-plug,\"h;2, b\"\n");
}

TEST(TubeTable, ReadsALargeListInLinearTime) {
  const auto seconds = [](int rows) {
    std::string text = "Row;Col;Status;Exam\n";
    for (int k = 0; k < rows; ++k)
      text += std::to_string(k / 130 + 1) + ";" + std::to_string(k % 130 + 1) + ";NDD;Bobbin\n";
    const auto start = std::chrono::steady_clock::now();
    const WorkList list = parseWorkListCsv(text);
    EXPECT_EQ(list.items.size(), static_cast<std::size_t>(rows));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  (void)seconds(1000);
  const double of_few = seconds(15'529), of_many = seconds(4 * 15'529);
  EXPECT_LT(of_many, 12 * of_few + 0.2) << "four times the rows";
}

}  // namespace
}  // namespace tubeplan::tubesheets
