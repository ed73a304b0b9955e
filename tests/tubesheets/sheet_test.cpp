// Tests of sheets: names, neighbours, mirror images, fingerprints, and problems that make a sheet unusable.
#include "tubesheets/sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>
#include <set>

#include "tests/tubesheets/example_sheets.hpp"

namespace tubeplan::tubesheets {
namespace {

bool mentions(const std::vector<Problem>& problems, const std::string& text) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const Problem& problem) { return problem.sentence().find(text) != std::string::npos; });
}

TEST(TubeStates, HaveNamesForFilesAndWordsForReaders) {
  std::set<std::string_view> words;
  for (const TubeState state : tubeStates()) {
    EXPECT_EQ(findTubeState(tubeStateName(state)), state);
    EXPECT_TRUE(words.insert(tubeStateWords(state)).second);
  }
  EXPECT_EQ(tubeStates().size(), 7U);
  EXPECT_EQ(tubeStateWords(TubeState::kToPlug), "recommended to plug");
  EXPECT_EQ(legWords(Leg::kFull), "full sheet");
  EXPECT_EQ(viewedFromWords(ViewedFrom::kBelow), "seen from below");
}

class ExampleSheetTest : public testing::TestWithParam<ExampleSheet> {};

TEST_P(ExampleSheetTest, HasNoProblems) {
  ASSERT_TRUE(findDescriptionProblems(GetParam().description).empty());
  const std::vector<Problem> problems = findSheetProblems(makeSheet(GetParam().description));
  EXPECT_TRUE(problems.empty()) << problems.front().sentence();
}

TEST_P(ExampleSheetTest, FindsEveryTubeByName) {
  const Sheet sheet = makeSheet(GetParam().description);
  for (int i = 0; i < static_cast<int>(sheet.tubes.size()); ++i) {
    EXPECT_EQ(sheet.indexOf(sheet.tubes[i].row, sheet.tubes[i].column), i);
    EXPECT_EQ(sheet.find(sheet.tubes[i].row, sheet.tubes[i].column), &sheet.tubes[i]);
  }
  EXPECT_EQ(sheet.find(sheet.rows + 1, 1), nullptr);
  EXPECT_EQ(sheet.find(0, 0), nullptr);
}

TEST_P(ExampleSheetTest, NeighboursAreMutualAndAgreeWithTheSlowSearch) {
  const Sheet sheet = makeSheet(GetParam().description);
  const auto neighbours = findNeighbours(sheet);
  const std::size_t inside = sheet.layout_type == "square" ? 4 : 6;
  std::size_t most = 0;
  for (int i = 0; i < static_cast<int>(sheet.tubes.size()); ++i) {
    most = std::max(most, neighbours[i].size());
    for (const int other : neighbours[i])
      EXPECT_TRUE(std::count(neighbours[other].begin(), neighbours[other].end(), i));
    if (i % 97 == 0) {
      EXPECT_EQ(neighbours[i], sheet.neighbours(i));
    }
  }
  EXPECT_EQ(most, inside);
}

INSTANTIATE_TEST_SUITE_P(All, ExampleSheetTest, testing::ValuesIn(exampleSheets()),
                         [](const auto& sheet) { return sheet.param.name; });

TEST(Sheet, SmallOneIsAsCountedByHand) {
  const Sheet sheet = makeSheet(smallDescription());
  ASSERT_EQ(sheet.tubes.size(), 26u);
  EXPECT_EQ(sheet.rows, 4);
  EXPECT_EQ(sheet.columns, 8);
  EXPECT_EQ(sheet.find(3, 1), nullptr);
  EXPECT_EQ(sheet.neighbours(*sheet.indexOf(1, 1)).size(), 2u);
  EXPECT_EQ(sheet.neighbours(*sheet.indexOf(2, 4)).size(), 4u);
}

TEST(Sheet, TheColdLegIsTheMirrorImage) {
  SheetDescription description = mockupDescription();
  const Sheet hot = makeSheet(description);
  description.leg = Leg::kCold;
  const Sheet cold = makeSheet(description);
  ASSERT_EQ(cold.tubes.size(), hot.tubes.size());
  for (std::size_t i = 0; i < hot.tubes.size(); ++i) {
    EXPECT_EQ(tubeName(cold.tubes[i].row, cold.tubes[i].column), tubeName(hot.tubes[i].row, hot.tubes[i].column));
    EXPECT_EQ(cold.tubes[i].x, hot.tubes[i].x);
    EXPECT_EQ(cold.tubes[i].y, -hot.tubes[i].y);
  }
  EXPECT_NE(cold.fingerprint(), hot.fingerprint());
  EXPECT_TRUE(findSheetProblems(cold).empty());
}

TEST(Fingerprint, IsStableAcrossReleases) {
  // If this fingerprint changes, all work lists that users have saved become invalid.
  EXPECT_EQ(makeSheet(smallDescription()).fingerprint(), "fbced66195b21aa8");
  EXPECT_EQ(makeSheet(mockupDescription()).fingerprint(), "c23137934490cc81");
}

TEST(Fingerprint, SeesGeometryAndNumbersButNotNameAndState) {
  const Sheet sheet = makeSheet(smallDescription());
  const std::string before = sheet.fingerprint();
  EXPECT_EQ(before.size(), 16u);
  Sheet changed = sheet;
  changed.name = "another";
  changed.tubes[3].state = TubeState::kPlugged;
  changed.tubes[3].x += 1e-13;
  EXPECT_EQ(changed.fingerprint(), before);
  std::set<std::string> seen{before};
  for (int change = 0; change < 6; ++change) {
    changed = sheet;
    if (change == 0) changed.leg = Leg::kCold;
    if (change == 1) changed.pitch += 2e-9;
    if (change == 2) changed.hole_diameter += 2e-9;
    if (change == 3) changed.tubes[3].y += 2e-9;
    if (change == 4) changed.tubes[3].column += 1;
    if (change == 5) changed.layout_type = "triangular";
    EXPECT_TRUE(seen.insert(changed.fingerprint()).second) << change;
  }
}

TEST(Fingerprint, DoesNotDependOnTheOrderOfTheHoles) {
  const Sheet sheet = makeSheet(mockupDescription());
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::vector<Tube> tubes = sheet.tubes;
    std::shuffle(tubes.begin(), tubes.end(), std::mt19937_64(seed));
    EXPECT_EQ(makeSheet(mockupDescription(), tubes).fingerprint(), sheet.fingerprint());
  }
}

TEST(DescriptionProblems, NameTheKey) {
  const auto first = [](auto change) {
    SheetDescription description = smallDescription();
    change(description);
    const auto problems = findDescriptionProblems(description);
    return problems.empty() ? std::string("none") : problems.front().what;
  };
  EXPECT_EQ(first([](auto&) {}), "none");
  EXPECT_EQ(first([](auto& d) { d.hole_diameter = kNan; }), "hole_diameter");
  EXPECT_EQ(first([](auto& d) { d.hole_diameter = d.layout.pitch; }), "hole_diameter");
  EXPECT_EQ(first([](auto& d) { d.hole_diameter = 0.7; }), "hole_diameter");  // value in inches, read as metres
  EXPECT_EQ(first([](auto& d) { d.leg = Leg::kFull; }), "leg");
  EXPECT_EQ(first([](auto& d) { d.layout = layoutInInches("disc", 1, 0, 4); }), "leg");
  EXPECT_EQ(first([](auto& d) { d.layout.first_row = 0.005; }), "first_row");
  EXPECT_EQ(first([](auto& d) { d.layout.pitch = kNan; }), "pitch");
}

TEST(SheetProblems, EmptySheet) {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes.clear();
  EXPECT_TRUE(mentions(findSheetProblems(sheet), "no holes"));
  EXPECT_FALSE(findSheetProblems(Sheet{}).empty());
}

TEST(SheetProblems, DuplicateName) {
  std::vector<Tube> tubes = makeSheet(smallDescription()).tubes;
  tubes.push_back({2, 3, 0.0, 0.2});
  EXPECT_TRUE(mentions(findSheetProblems(makeSheet(smallDescription(), tubes)), "R2C3: two holes have this name"));
}

TEST(SheetProblems, OverlapNamesBothHoles) {
  Sheet sheet = makeSheet(smallDescription());
  Tube& moved = sheet.tubes[*sheet.indexOf(2, 3)];
  moved.x = sheet.find(2, 4)->x - 0.99 * sheet.hole_diameter;
  const auto problems = findSheetProblems(sheet);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().what, "R2C3 and R2C4");
  moved.x = sheet.find(2, 4)->x - 1.01 * sheet.hole_diameter;
  EXPECT_TRUE(findSheetProblems(sheet).empty());
}

TEST(SheetProblems, NotFiniteOrHuge) {
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -1e300, 1e9}) {
    Sheet sheet = makeSheet(smallDescription());
    sheet.tubes[5].x = bad;
    EXPECT_TRUE(mentions(findSheetProblems(sheet), tubeName(sheet.tubes[5].row, sheet.tubes[5].column))) << bad;
  }
}

TEST(SheetProblems, NumbersBelowOneAndDiameterOverPitch) {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes[0].row = 0;
  EXPECT_TRUE(mentions(findSheetProblems(sheet), "below 1"));
  sheet = makeSheet(smallDescription());
  sheet.hole_diameter = sheet.pitch;
  EXPECT_TRUE(mentions(findSheetProblems(sheet), "hole_diameter"));
  sheet.pitch = kNan;
  EXPECT_TRUE(mentions(findSheetProblems(sheet), "pitch"));
}

TEST(SheetProblems, OutOfOrder) {
  Sheet sheet = makeSheet(smallDescription());
  std::swap(sheet.tubes[4], sheet.tubes[9]);
  EXPECT_TRUE(mentions(findSheetProblems(sheet), "listed after"));
}

TEST(SheetProblems, AMapOfTheOtherLeg) {
  SheetDescription description = smallDescription();
  const std::vector<Tube> hot = makeSheet(description).tubes;
  description.leg = Leg::kCold;
  EXPECT_TRUE(mentions(findSheetProblems(makeSheet(description, hot)), "mirror image"));
}

TEST(SheetProblems, WrongUnit) {
  for (const double scale : {1 / 25.4, 1 / 0.0254, 25.4, 0.0254}) {
    std::vector<Tube> tubes = makeSheet(mockupDescription()).tubes;
    for (Tube& tube : tubes) {
      tube.x *= scale;
      tube.y *= scale;
    }
    EXPECT_TRUE(mentions(findSheetProblems(makeSheet(mockupDescription(), tubes)), "check the unit")) << scale;
  }
}

TEST(SheetProblems, AFewHolesFarApartAreNoFault) {
  const std::vector<Tube> tubes{{3, 10, -1.2, 0.3}, {20, 60, 0.05, 0.6}, {40, 57, 0.0, 1.1}};
  EXPECT_TRUE(findSheetProblems(makeSheet(mockupDescription(), tubes)).empty());
}

TEST(SheetProblems, StopAtTwenty) {
  Sheet sheet = makeSheet(mockupDescription());
  for (Tube& tube : sheet.tubes) tube.x = 0.1, tube.y = 0.1;
  const std::size_t count = findSheetProblems(sheet).size();
  EXPECT_GE(count, 1u);
  EXPECT_LE(count, 21u);
}

/// Returns the processor time of findSheetProblems() per hole [s], the smallest of five runs.
double secondsPerHole(const SheetDescription& description, int repeats) {
  const Sheet sheet = makeSheet(description);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    for (int k = 0; k < repeats; ++k) EXPECT_TRUE(findSheetProblems(sheet).empty());
    best = std::min(best, static_cast<double>(std::clock() - start));
  }
  return best / CLOCKS_PER_SEC / repeats / static_cast<double>(sheet.tubes.size());
}

// On the largest sheet, the check must cost less than 20 times as much per hole as on the small sheet. A check of all
// pairs of holes would cost some 600 times as much.
TEST(SheetProblems, AHoleOfTheLargestSheetIsCheckedAtTheCostOfAnyOther) {
  EXPECT_LT(secondsPerHole(exampleSheets()[6].description, 1), 20 * secondsPerHole(smallDescription(), 500));
}

TEST(SheetProblems, APitchThatTheHolesDoNotHave) {
  for (const double off : {0.95, 1.05}) {
    Sheet sheet = makeSheet(mockupDescription());
    sheet.pitch *= off;
    EXPECT_TRUE(mentions(findSheetProblems(sheet), "pitch")) << off;
  }
  Sheet rounded = makeSheet(mockupDescription());
  rounded.pitch *= 1.005;
  EXPECT_TRUE(findSheetProblems(rounded).empty());
}

TEST(SheetProblems, MillimetresReadAsInchesOfHolesFarApart) {
  const auto withEvery = [](int step, double unit) {
    Sheet sheet = makeSheet(mockupDescription());
    std::erase_if(sheet.tubes, [&](const Tube& tube) { return tube.row % step != 0 || tube.column % step != 0; });
    for (Tube& tube : sheet.tubes) tube.x *= unit, tube.y *= unit;
    return findSheetProblems(sheet);
  };
  for (const int step : {3, 4}) {  // not 5, because 25.4 times five pitches is again a whole number of pitches
    EXPECT_TRUE(withEvery(step, 1).empty()) << step;
    EXPECT_FALSE(withEvery(step, 25.4).empty()) << step;
  }
}

}  // namespace
}  // namespace tubeplan::tubesheets
