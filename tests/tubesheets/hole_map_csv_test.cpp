// Tests of hole maps as text: exact round trips, short decimals, and refusal of malformed text with its line number.
#include "tubesheets/hole_map_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "tests/tubesheets/example_sheets.hpp"

namespace tubeplan::tubesheets {
namespace {

class RoundTrip : public testing::TestWithParam<ExampleSheet> {};

TEST_P(RoundTrip, IsExactInEveryUnit) {
  Sheet sheet = makeSheet(GetParam().description);
  for (std::size_t i = 0; i < sheet.tubes.size(); i += 7) sheet.tubes[i].state = static_cast<TubeState>(i % 7);
  for (const LengthUnit& unit : lengthUnits()) {
    const HoleMap map = parseHoleMap(formatHoleMap(sheet, unit));
    ASSERT_EQ(map.status, TubeTextStatus::kRead) << map.problem->sentence();
    ASSERT_EQ(map.tubes.size(), sheet.tubes.size());
    for (std::size_t i = 0; i < sheet.tubes.size(); ++i) {
      EXPECT_EQ(map.tubes[i].row, sheet.tubes[i].row);
      EXPECT_EQ(map.tubes[i].column, sheet.tubes[i].column);
      EXPECT_EQ(map.tubes[i].x, sheet.tubes[i].x);
      EXPECT_EQ(map.tubes[i].y, sheet.tubes[i].y);
      EXPECT_EQ(map.tubes[i].state, sheet.tubes[i].state);
    }
    EXPECT_EQ(makeSheet(GetParam().description, map.tubes).fingerprint(), sheet.fingerprint());
  }
}

INSTANTIATE_TEST_SUITE_P(All, RoundTrip, testing::ValuesIn(exampleSheets()),
                         [](const auto& sheet) { return sheet.param.name; });

TEST(FormatHoleMap, PrintsInchesAsDrawn) {
  const std::string text = formatHoleMap(makeSheet(mockupDescription()), kInch);
  EXPECT_EQ(text.substr(0, text.find('\n')), "row,column,x_in,y_in,state");
  EXPECT_NE(text.find("\n1,57,-0.53125,2.28,open\n"), std::string::npos);
  EXPECT_NE(text.find("\n2,59,1.59375,3.3425,open\n"), std::string::npos);
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 30u) << line;
  EXPECT_EQ(count, 4675u);
}

TEST(FormatHoleMap, ColumnOfTheDiscThroughTheMiddleIsPlainZero) {
  const std::string text = formatHoleMap(makeSheet(exampleSheets()[6].description), kInch);
  EXPECT_EQ(text.find(",-0,"), std::string::npos);
  EXPECT_NE(text.find(",0,0,open"), std::string::npos);
}

TEST(FormatLength, ComesBackForRandomLengths) {
  for (const unsigned seed : {11u, 12u, 13u}) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 2000; ++i) {
      const double length = snapLength(std::ldexp(static_cast<double>(random() >> 11), -53) * 8 - 4);
      for (const LengthUnit& unit : lengthUnits())
        EXPECT_EQ(snapLength(std::stod(formatLength(length, unit)) * unit.metres), length);
    }
  }
}

TEST(ParseHoleMap, ReadsColumnsInAnyOrderWithUnitsLegAndStates) {
  const HoleMap map = parseHoleMap(
      "\xEF\xBB\xBFleg, state ,y_mm,x_mm,column,row,comment\r\n"
      "# drilled 1988\r\n\r\n"
      "CL,plugged,-25.4,50.8,3,2,\"leaks, see log\"\r\n"
      "cold,,-5e1,0,1,1,\r\n");
  ASSERT_EQ(map.status, TubeTextStatus::kRead) << map.problem->sentence();
  ASSERT_EQ(map.tubes.size(), 2u);
  EXPECT_EQ(map.leg, Leg::kCold);
  EXPECT_EQ(map.tubes[0].row, 2);
  EXPECT_EQ(map.tubes[0].column, 3);
  EXPECT_NEAR(map.tubes[0].x, 0.0508, 1e-13);
  EXPECT_NEAR(map.tubes[0].y, -0.0254, 1e-13);
  EXPECT_EQ(map.tubes[0].state, TubeState::kPlugged);
  EXPECT_EQ(map.tubes[1].state, TubeState::kOpen);
  EXPECT_NEAR(map.tubes[1].y, -0.05, 1e-13);
}

TEST(ParseHoleMap, TheStateColumnIsOptional) {
  const HoleMap map = parseHoleMap("row,column,x_m,y_m\n1,1,0.5,0.25\n");
  ASSERT_EQ(map.status, TubeTextStatus::kRead);
  EXPECT_EQ(map.tubes[0].x, 0.5);
  EXPECT_EQ(map.tubes[0].state, TubeState::kOpen);
  EXPECT_FALSE(map.leg.has_value());
}

struct BadText {
  std::string name;
  std::string text;
  int line;
  std::string found;  // expected part of the problem's sentence
};

void PrintTo(const BadText& text, std::ostream* out) { *out << text.name; }

class RefusedHoleMap : public testing::TestWithParam<BadText> {};

TEST_P(RefusedHoleMap, SaysWhereAndWhat) {
  const HoleMap map = parseHoleMap(GetParam().text);
  ASSERT_EQ(map.status, TubeTextStatus::kRefused);
  ASSERT_TRUE(map.problem.has_value());
  EXPECT_TRUE(map.tubes.empty());
  EXPECT_EQ(map.problem->line, GetParam().line) << map.problem->sentence();
  EXPECT_NE(map.problem->sentence().find(GetParam().found), std::string::npos) << map.problem->sentence();
  EXPECT_FALSE(map.problem->expected.empty() && map.problem->advice.empty());
}

const std::string kHeader = "row,column,x_in,y_in,state\n";

INSTANTIATE_TEST_SUITE_P(
    All, RefusedHoleMap,
    testing::Values(
        BadText{"Empty", "", 0, "no header line"}, BadText{"OnlyBlanks", "\n \n\t\n", 0, "no header line"},
        BadText{"NoHeader", "1,2,0.5,0.5,open\n", 1, "add a header line"},
        BadText{"OnlyHeader", kHeader, 1, "no holes"}, BadText{"MissingRow", "column,x_in,y_in\n1,1,1\n", 1, "\"row\""},
        BadText{"MissingX", "row,column,y_in\n1,1,1\n", 1, "no column for x"},
        BadText{"NoUnit", "row,column,x,y\n1,1,1,1\n", 1, "x_in, x_mm or x_m"},
        BadText{"UnknownUnit", "row,column,x_ft,y_ft\n1,1,1,1\n", 1, "x_in, x_mm or x_m"},
        BadText{"TwoUnits", "row,column,x_in,y_mm\n1,1,1,1\n", 1, "in and mm"},
        BadText{"XTwice", "row,column,x_in,x_mm,y_in\n1,1,1,1,1\n", 1, "two units"},
        BadText{"ColumnTwice", "row,row,column,x_in,y_in\n1,1,1,1,1\n", 1, "\"row\" occurs twice"},
        BadText{"NamelessColumn", "row,column,x_in,y_in,\n1,1,1,1,\n", 1, "no name"},
        BadText{"UnknownColumn", "row,column,x_in,y_in,stat\n1,1,1,1,open\n", 1, "\"stat\""},
        BadText{"NaN", kHeader + "1,1,0,1,open\n1,2,nan,1,open\n", 3, "\"nan\""},
        BadText{"Infinite", kHeader + "1,1,0,inf,open\n", 2, "\"inf\""},
        BadText{"TooLargeForADouble", kHeader + "1,1,0,1e999,open\n", 2, "\"1e999\""},
        BadText{"EmptyNumber", kHeader + "1,1,,1,open\n", 2, "x_in"},
        BadText{"NumberWithUnit", kHeader + "1,1,2 in,1,open\n", 2, "\"2 in\""},
        BadText{"DecimalComma", kHeader + "1,1,\"2,5\",1,open\n", 2, "\"2,5\""},
        BadText{"RowIsZero", kHeader + "0,1,1,1,open\n", 2, "row"},
        BadText{"RowIsNegative", kHeader + "-3,1,1,1,open\n", 2, "\"-3\""},
        BadText{"RowIsAFraction", kHeader + "1.5,1,1,1,open\n", 2, "\"1.5\""},
        BadText{"ColumnIsHuge", kHeader + "1,99999999999999999999,1,1,open\n", 2, "column"},
        BadText{"Duplicate", kHeader + "1,1,0,1,open\n1,2,1,1,open\n\n1,1,2,1,open\n", 5, "first on line 2"},
        BadText{"UnknownState", kHeader + "1,1,0,1,blocked\n", 2, "\"blocked\""},
        BadText{"TooFewFields", kHeader + "1,1,0\n", 2, "3 fields"},
        BadText{"TooManyFields", kHeader + "1,1,0,1,open,x\n", 2, "6 fields"},
        BadText{"OpenQuote", kHeader + "1,1,0,1,\"open\n", 2, "quote"},
        BadText{"Junk",
                "\x7f"
                "ELF\x02\x01\n",
                1, "no line names the columns"},
        BadText{"ZeroByte", kHeader + std::string("1,1,0,\0,open\n", 13), 2, "zero byte"},
        BadText{"CommaBelowSemicolons", "row;column;x_in;y_in\n1;1;1;1\n1,2,2,1\n", 3, "separated by commas"},
        BadText{"TwoStates", "row,column,x_in,y_in,state,ind\n1,1,1,1,PLG,SLV\n", 2,
                "plugged, as in the column beside it"},
        BadText{"UnknownLeg", "row,column,x_in,y_in,leg\n1,1,1,1,warm\n", 2, "\"warm\""},
        BadText{"TwoLegs", "row,column,x_in,y_in,leg\n1,1,1,1,hot\n1,2,1,1,cold\n", 3, "keep one map"}),
    [](const auto& sheet) { return sheet.param.name; });

TEST(ParseHoleMap, SurvivesAnyBytes) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    std::mt19937_64 random(seed);
    const std::string good = formatHoleMap(makeSheet(smallDescription()));
    for (int i = 0; i < 400; ++i) {
      std::string text = good;
      for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(random() % 256);
      const HoleMap map = parseHoleMap(text);
      EXPECT_NE(map.status, TubeTextStatus::kNotRun);
      EXPECT_EQ(map.status == TubeTextStatus::kRefused, map.problem.has_value());
    }
  }
}

}  // namespace
}  // namespace tubeplan::tubesheets
