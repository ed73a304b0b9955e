// Tests of layouts: published hole counts, and layouts that are refused.
#include "tubesheets/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "tests/tubesheets/example_sheets.hpp"
#include "tubesheets/layouts.hpp"

namespace tubeplan::tubesheets {
namespace {

class PublishedLayout : public testing::TestWithParam<ExampleSheet> {};

TEST_P(PublishedLayout, HasTheCount) {
  const Layout& layout = GetParam().description.layout;
  ASSERT_TRUE(findLayoutProblems(layout).empty());
  EXPECT_EQ(static_cast<int>(makeTubes(layout).size()), GetParam().holes);
}

TEST_P(PublishedLayout, DerivesTheColumnsThatAreStated) {
  Layout layout = GetParam().description.layout;
  const std::vector<Tube> stated = makeTubes(layout);
  layout.columns = 0;
  const std::vector<Tube> derived = makeTubes(layout);
  ASSERT_EQ(derived.size(), stated.size());
  for (std::size_t i = 0; i < stated.size(); ++i) {
    EXPECT_EQ(derived[i].column, stated[i].column);
    EXPECT_EQ(derived[i].x, stated[i].x);
  }
}

TEST_P(PublishedLayout, IsSymmetricAboutTheMiddle) {
  std::set<std::pair<double, double>> places;
  const std::vector<Tube> tubes = makeTubes(GetParam().description.layout);
  for (const Tube& tube : tubes) places.insert({tube.x, tube.y});
  for (const Tube& tube : tubes) EXPECT_TRUE(places.contains({-tube.x + 0.0, tube.y})) << tube.x << " " << tube.y;
}

TEST_P(PublishedLayout, KeepsItsDistances) {
  const Layout& layout = GetParam().description.layout;
  for (const Tube& tube : makeTubes(layout)) {
    EXPECT_LE(std::hypot(tube.x, tube.y), layout.radius + 1e-12);
    EXPECT_GE(std::hypot(tube.x, tube.y), layout.stay_radius - 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PublishedLayout, testing::ValuesIn(exampleSheets()),
                         [](const auto& sheet) { return sheet.param.name; });

/// Returns the example sheets whose numbers of rows and columns are known.
std::vector<ExampleSheet> sheetsWithGrid() {
  std::vector<ExampleSheet> sheets = exampleSheets();
  std::erase_if(sheets, [](const ExampleSheet& sheet) { return sheet.rows == 0; });
  return sheets;
}

class PublishedGrid : public testing::TestWithParam<ExampleSheet> {};

TEST_P(PublishedGrid, HasTheRowsAndColumns) {
  const std::vector<Tube> tubes = makeTubes(GetParam().description.layout);
  int rows = 0, columns = 0;
  for (const Tube& tube : tubes) {
    rows = std::max(rows, tube.row);
    columns = std::max(columns, tube.column);
  }
  EXPECT_EQ(rows, GetParam().rows);
  EXPECT_EQ(columns, GetParam().columns);
}

INSTANTIATE_TEST_SUITE_P(All, PublishedGrid, testing::ValuesIn(sheetsWithGrid()),
                         [](const auto& sheet) { return sheet.param.name; });

TEST(Layout, MatchesItsFormulaAtSomeHoles) {
  const std::vector<Tube> tubes = makeTubes(mockupDescription().layout);
  const auto tube =
      std::find_if(tubes.begin(), tubes.end(), [](const Tube& t) { return t.row == 10 && t.column == 20; });
  ASSERT_NE(tube, tubes.end());
  EXPECT_NEAR(tube->x, (20 - 57.5) * 1.0625 * kMetresPerInch, 1e-13);
  EXPECT_NEAR(tube->y, (2.28 + 9 * 1.0625) * kMetresPerInch, 1e-13);
}

TEST(Layout, DoesNotDependOnTheUnit) {
  for (const double scale : {1e-6, 0.001, 1.0 / 3, 7.77, 1e5}) {
    for (const ExampleSheet& sheet : exampleSheets()) {
      Layout layout = sheet.description.layout;
      for (double* length : {&layout.pitch, &layout.first_row, &layout.radius, &layout.stay_radius}) *length *= scale;
      EXPECT_EQ(static_cast<int>(makeTubes(layout).size()), sheet.holes) << sheet.name << " times " << scale;
    }
  }
}

TEST(Layout, ACentreOnTheCircleIsInside) {
  // 3-4-5 triangle: the hole at (3, 4) pitches lies on the circle, for any rounding of the pitch.
  for (const double pitch : {0.1, 0.3, 0.7, 1.1, 0.0254 * 0.3}) {
    const std::vector<Tube> tubes = makeTubes({"square", pitch, 4 * pitch, 5 * pitch, 0, 1, 7});
    ASSERT_EQ(tubes.size(), 7u) << pitch;
  }
}

TEST(Layout, TriangularColumnsAlternateByParity) {
  const std::vector<Tube> tubes = makeTubes(layoutInInches("triangular", 1, 2, 20));
  const int parity = (tubes.front().row + tubes.front().column) % 2;
  for (const Tube& tube : tubes) EXPECT_EQ((tube.row + tube.column) % 2, parity);
}

TEST(Layout, TheDiscNumbersEachRowFromOne) {
  const std::vector<Tube> tubes = makeTubes(exampleSheets()[6].description.layout);
  EXPECT_EQ(tubes.front().row, 1);
  for (std::size_t i = 1; i < tubes.size(); ++i)
    EXPECT_EQ(tubes[i].column, tubes[i].row == tubes[i - 1].row ? tubes[i - 1].column + 1 : 1);
  EXPECT_EQ(std::count_if(tubes.begin(), tubes.end(), [](const Tube& tube) { return tube.row == 1; }), 16);
}

TEST(LayoutTypes, HaveUniqueNamesAndSayWhatTheyAre) {
  std::set<std::string_view> names;
  for (const LayoutType& type : layoutTypes()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name;
    EXPECT_EQ(findLayoutType(type.name), &type);
    EXPECT_FALSE(type.sentence.empty());
    EXPECT_FALSE(type.keys.empty());
  }
  EXPECT_EQ(findLayoutType("hexagonal"), nullptr);
}

struct BadLayout {
  std::string name;
  Layout layout;
  std::string what;  // expected field of the first problem
};

void PrintTo(const BadLayout& layout, std::ostream* out) { *out << layout.name; }

class RefusedLayout : public testing::TestWithParam<BadLayout> {};

TEST_P(RefusedLayout, NamesTheKey) {
  const std::vector<Problem> problems = findLayoutProblems(GetParam().layout);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.front().what, GetParam().what) << problems.front().sentence();
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, RefusedLayout,
    testing::Values(BadLayout{"UnknownType", {"hexagonal", 1, 2, 20}, "type"}, BadLayout{"NoType", {}, "type"},
                    BadLayout{"MissingPitch", {"square", kNan, 2, 20}, "pitch"},
                    BadLayout{"ZeroPitch", {"square", 0, 2, 20}, "pitch"},
                    BadLayout{"NegativePitch", {"triangular", -1, 2, 20}, "pitch"},
                    BadLayout{"MissingFirstRow", {"square", 1, kNan, 20}, "first_row"},
                    BadLayout{"InfiniteRadius", {"disc", 1, 0, kInfinity}, "radius"},
                    BadLayout{"HugeRadius", {"disc", 0.001, 0, 1e9}, "radius"},
                    BadLayout{"PitchInOtherUnit", {"square", 1.0625 * 0.0254 / 25.4, 0.058, 1.534}, "radius"},
                    BadLayout{"StayOverRadius", {"triangular", 1, 2, 20, 20}, "stay_radius"},
                    BadLayout{"NegativeRows", {"square", 1, 2, 20, 0, -1}, "rows"},
                    BadLayout{"HugeColumns", {"square", 1, 2, 20, 0, 0, 2000000000}, "columns"},
                    BadLayout{"MoreColumnsThanFit", {"square", 1, 2, 20, 0, 0, 42}, "columns"},
                    BadLayout{"EvenTriangularColumns", {"triangular", 1, 2, 20, 0, 0, 40}, "columns"},
                    BadLayout{"NoHoles", {"square", 1, 21, 20}, "layout"}),
    [](const auto& sheet) { return sheet.param.name; });

}  // namespace
}  // namespace tubeplan::tubesheets
