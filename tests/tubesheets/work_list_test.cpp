// Tests of the selection language: every term, and every reason for refusal.
#include "tubesheets/work_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/tubesheets/example_sheets.hpp"
#include "tubesheets/selection_terms.hpp"
#include "tubesheets/tube_choice.hpp"

namespace tubeplan::tubesheets {
namespace {

/// Returns the small sheet with R1C3 and R2C5 plugged and R4C4 sleeved.
Sheet sheetWithStates() {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes[*sheet.indexOf(1, 3)].state = TubeState::kPlugged;
  sheet.tubes[*sheet.indexOf(2, 5)].state = TubeState::kPlugged;
  sheet.tubes[*sheet.indexOf(4, 4)].state = TubeState::kSleeved;
  return sheet;
}

/// Returns the names of the selected tubes, for example "R1C2 R1C3", or the reason for a refusal.
std::string namesOf(const Sheet& sheet, const std::string& request) {
  const Selection selection = selectTubes(sheet, request);
  if (selection.status != SelectionStatus::kSelected) return "refused: " + selection.reason;
  std::string names;
  for (const int tube : selection.tube_indices)
    names += (names.empty() ? "" : " ") + tubeName(sheet.tubes[tube].row, sheet.tubes[tube].column);
  return names;
}

std::size_t countOf(const Sheet& sheet, const std::string& request) {
  const Selection selection = selectTubes(sheet, request);
  EXPECT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason;
  return selection.tube_indices.size();
}

TEST(SelectTubes, AllAndRanges) {
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(countOf(sheet, "all"), 26u);
  EXPECT_EQ(namesOf(sheet, "R2C3"), "R2C3");
  EXPECT_EQ(namesOf(sheet, "r2c3"), "R2C3");
  EXPECT_EQ(namesOf(sheet, "R4"), "R4C3 R4C4 R4C5 R4C6");
  EXPECT_EQ(namesOf(sheet, "C1"), "R1C1 R2C1");
  EXPECT_EQ(namesOf(sheet, "R2-3C1-2"), "R2C1 R2C2 R3C2");
  EXPECT_EQ(countOf(sheet, "R1-4C1-8"), 26u);
}

TEST(SelectTubes, UnionIsInSheetOrderAndUnique) {
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(namesOf(sheet, "R4C4, R1C1 ,R4C4,R1C1-2"), "R1C1 R1C2 R4C4");
}

TEST(SelectTubes, MinusTakesAway) {
  const Sheet sheet = sheetWithStates();
  EXPECT_EQ(namesOf(sheet, "R4,-R4C5"), "R4C3 R4C4 R4C6");
  EXPECT_EQ(namesOf(sheet, "-R4C5,R4"), "R4C3 R4C4 R4C6");
  EXPECT_EQ(countOf(sheet, "-plugged"), 24u);
  EXPECT_EQ(countOf(sheet, "all,-plugged,-sleeved"), 23u);
  EXPECT_EQ(namesOf(sheet, "plugged"), "R1C3 R2C5");
  EXPECT_EQ(namesOf(sheet, "all,-open,-plugged"), "R4C4");
  EXPECT_EQ(namesOf(sheet, "R1,-R1C4-8,-plugged"), "R1C1 R1C2");
}

TEST(SelectTubes, PluggedOnesAreLeftOutAndCountedUnlessAskedForByName) {
  Sheet sheet = sheetWithStates();
  sheet.tubes[*sheet.indexOf(4, 5)].state = TubeState::kStabilised;
  EXPECT_EQ(countOf(sheet, "all"), 23u);
  EXPECT_EQ(countOf(sheet, "R1-4C1-8"), 23u);
  EXPECT_EQ(countOf(sheet, "all,plugged"), 25u);
  EXPECT_EQ(countOf(sheet, "all,plugged,stabilised"), 26u);
  EXPECT_EQ(namesOf(sheet, "R1C3"), "R1C3");
  EXPECT_EQ(leftOutText(selectTubes(sheet, "all")), "2 plugged, 1 stabilised");
  EXPECT_EQ(leftOutText(selectTubes(sheet, "all,plugged,stabilised")), "");
  EXPECT_EQ(leftOutText(selectTubes(sheet, "all,-plugged")), "1 stabilised");
  const Selection none = selectTubes(sheet, "R4C5-5");
  EXPECT_EQ(none.status, SelectionStatus::kRefused);
  EXPECT_NE(none.reason.find("1 stabilised"), std::string::npos) << none.reason;
}

TEST(SelectTubes, AWorkListsStateCountsBeforeTheSheets) {
  const Sheet sheet = sheetWithStates();
  const Selection selection =
      selectTubes(sheet, parseWorkListCsv("row,column,state\n1,1,plugged\n1,2,\n1,3,open\n2,5,\n"));
  ASSERT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason;
  EXPECT_EQ(selection.tube_indices, (std::vector<int>{*sheet.indexOf(1, 2), *sheet.indexOf(1, 3)}));
  EXPECT_EQ(leftOutText(selection), "1 plugged, 1 plugged according to the list");
  EXPECT_EQ(parseWorkListCsv("row,column,state\n1,1,plugd\n").status, TubeTextStatus::kRefused);
}

TEST(SelectTubes, InaccessibleAndUnresolvedOnesAreTakenOnlyWhereTheyAreNamedAndThenReported) {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes[*sheet.indexOf(1, 3)].state = TubeState::kInaccessible;
  sheet.tubes[*sheet.indexOf(2, 5)].state = TubeState::kUnresolved;
  for (const char* group : {"all", "R1-4C1-8", "-R1C1,-R1C2", "zone:-10:10:-10:10in"}) {
    const Selection selection = selectTubes(sheet, group);
    EXPECT_EQ(leftOutText(selection), "1 inaccessible, 1 unresolved") << group;
    EXPECT_EQ(doubtfulText(sheet, selection), "") << group;
  }
  EXPECT_EQ(countOf(sheet, "all,inaccessible"), 25u);
  EXPECT_EQ(doubtfulText(sheet, selectTubes(sheet, "all,inaccessible")),
            "1 inaccessible among the requested tubes (R1C3): included as requested");
  EXPECT_EQ(doubtfulText(sheet, selectTubes(sheet, "R1C1,R1C3,R2C5")),
            "1 inaccessible, 1 unresolved among the requested tubes (R1C3, R2C5): included as requested");
  EXPECT_EQ(doubtfulText(sheet, selectTubes(sheet, "all,inaccessible,-R1C3")), "");
}

TEST(SelectTubes, AWorkListNamesItsTubesSoThatDoubtfulOnesAreTakenAndReported) {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes[*sheet.indexOf(1, 3)].state = TubeState::kInaccessible;
  const Selection selection =
      selectTubes(sheet, parseWorkListCsv("row,column,state\n1,1,unresolved\n1,2,\n1,3,\n2,5,plugged\n"));
  ASSERT_EQ(selection.status, SelectionStatus::kSelected) << selection.reason;
  EXPECT_EQ(selection.tube_indices.size(), 3u);
  EXPECT_EQ(doubtfulText(sheet, selection),
            "1 inaccessible, 1 unresolved among the requested tubes (R1C1, R1C3): included as requested");
  EXPECT_EQ(leftOutText(selection), "1 plugged according to the list");
  const Selection opened = selectTubes(sheet, parseWorkListCsv("row,column,state\n1,3,open\n"));
  EXPECT_EQ(doubtfulText(sheet, opened), "");
}

TEST(SelectTubes, OuterPeelsTheSheet) {
  // Counted by hand: only these ten tubes have a hole on all four sides, and each is next to a tube that lacks one.
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(namesOf(sheet, "-outer:1"), "R2C2 R2C3 R2C4 R2C5 R2C6 R2C7 R3C3 R3C4 R3C5 R3C6");
  EXPECT_EQ(countOf(sheet, "outer:1"), 16u);
  EXPECT_EQ(countOf(sheet, "outer:2"), 26u);
  EXPECT_EQ(countOf(sheet, "outer:1000"), 26u);
}

TEST(SelectTubes, OuterGrowsWithDepthAndEndsAtAll) {
  for (const ExampleSheet& example : exampleSheets()) {
    const Sheet sheet = makeSheet(example.description);
    const std::vector<int> depths = peelDepths(sheet);
    const int deepest = *std::max_element(depths.begin(), depths.end());
    EXPECT_EQ(*std::min_element(depths.begin(), depths.end()), 1) << example.name;
    EXPECT_GT(deepest, 10) << example.name;
    const auto neighbours = findNeighbours(sheet);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      int shallowest = depths[i];
      for (const int other : neighbours[i]) shallowest = std::min(shallowest, depths[other]);
      if (depths[i] > 1) {
        EXPECT_EQ(shallowest, depths[i] - 1) << example.name << " " << i;
      }
    }
  }
}

TEST(SelectTubes, EveryThinsTheRest) {
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(namesOf(sheet, "R1,every:3"), "R1C1 R1C4 R1C7");
  EXPECT_EQ(namesOf(sheet, "every:3,R1"), "R1C1 R1C4 R1C7");
  EXPECT_EQ(namesOf(sheet, "R1,every:3,every:2"), "R1C1 R1C7");
  EXPECT_EQ(countOf(sheet, "every:1"), 26u);
  EXPECT_EQ(countOf(sheet, "every:5"), 6u);
  EXPECT_EQ(namesOf(sheet, "every:2000000000"), "R1C1");
}

TEST(SelectTubes, ZoneKnowsUnits) {
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(namesOf(sheet, "zone:-0.6:0.6:0:1.6in"), "R1C4 R1C5 R2C4 R2C5");
  EXPECT_EQ(namesOf(sheet, "zone:-15.24:15.24:0:40.64mm"), "R1C4 R1C5 R2C4 R2C5");
  EXPECT_EQ(namesOf(sheet, "zone:-0.5:0.5:0.5:0.5in"), "R1C4 R1C5");  // the unit applies to all limits of the zone
}

TEST(SelectTubes, GuardsPassTheRightSheet) {
  const Sheet sheet = makeSheet(smallDescription());
  EXPECT_EQ(namesOf(sheet, "leg:hot,sheet:" + sheet.fingerprint() + ",R2C3"), "R2C3");
}

double leastDistance(const Sheet& sheet, const std::vector<int>& chosen) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Tube &a = sheet.tubes[chosen[i]], &b = sheet.tubes[chosen[j]];
      least = std::min(least, std::hypot(a.x - b.x, a.y - b.y));
    }
  return least;
}

TEST(SelectTubes, SpreadIsEvenAndRepeatable) {
  const Sheet sheet = makeSheet(mockupDescription());
  for (const int count : {2, 10, 60, 300}) {
    const Selection selection = selectTubes(sheet, "spread:" + std::to_string(count));
    ASSERT_EQ(static_cast<int>(selection.tube_indices.size()), count);
    EXPECT_TRUE(std::is_sorted(selection.tube_indices.begin(), selection.tube_indices.end()));
    EXPECT_EQ(selection.tube_indices, selectTubes(sheet, "spread:" + std::to_string(count)).tube_indices);
    // Each selected tube was the one farthest from those before it, so no tube of the sheet may be farther from the
    // selection than the selected tubes are from each other.
    const double least = leastDistance(sheet, selection.tube_indices);
    double farthest = 0;
    for (const Tube& tube : sheet.tubes) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const int chosen : selection.tube_indices)
        nearest = std::min(nearest, std::hypot(tube.x - sheet.tubes[chosen].x, tube.y - sheet.tubes[chosen].y));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, least + 1e-12) << count;
  }
}

TEST(SelectTubes, SpreadComesAfterTheMinus) {
  Sheet sheet = makeSheet(mockupDescription());
  for (std::size_t i = 0; i < sheet.tubes.size(); i += 3) sheet.tubes[i].state = TubeState::kPlugged;
  const Selection selection = selectTubes(sheet, "spread:60,-plugged");
  ASSERT_EQ(selection.tube_indices.size(), 60u) << selection.reason;
  for (const int tube : selection.tube_indices) EXPECT_EQ(sheet.tubes[tube].state, TubeState::kOpen);
}

struct BadRequest {
  std::string request;
  std::string reason;  // expected part of the reason
};

void PrintTo(const BadRequest& bad, std::ostream* out) { *out << bad.request; }

class RefusedRequest : public testing::TestWithParam<BadRequest> {};

TEST_P(RefusedRequest, SaysWhy) {
  const Selection selection = selectTubes(sheetWithStates(), GetParam().request);
  ASSERT_EQ(selection.status, SelectionStatus::kRefused);
  EXPECT_TRUE(selection.tube_indices.empty());
  EXPECT_NE(selection.reason.find(GetParam().reason), std::string::npos) << selection.reason;
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedRequest,
    testing::Values(BadRequest{"", "item 1 \"\" (character 1)"}, BadRequest{"all,", "item 2"},
                    BadRequest{"all,,R1", "item 2 \"\" (character 5)"},
                    BadRequest{"R60C3", "R60C3 is not on this sheet: rows 1 to 4, columns 1 to 8"},
                    BadRequest{"R1C1, R3C1", "item 2 \"R3C1\" (character 7): R3C1 is not on this sheet"},
                    BadRequest{"R3C1", "row 3 has columns 2 to 7"}, BadRequest{"-R60C3", "R60C3 is not on this sheet"},
                    BadRequest{"R1-60", "row 60 is not on this sheet: rows 1 to 4"},
                    BadRequest{"C9", "column 9 is not on this sheet"},
                    BadRequest{"R3-2", "the limits row 3 to 2 are reversed"},
                    BadRequest{"R3-4C1", "no hole of this sheet lies in that range"},
                    BadRequest{"R0C1", "expected a range"}, BadRequest{"R", "expected a range"},
                    BadRequest{"R1C", "expected a range"}, BadRequest{"R1-C2", "expected a range"},
                    BadRequest{"R1C2X", "expected a range"}, BadRequest{"C2R1", "expected a range"},
                    BadRequest{"R-5", "expected a range"}, BadRequest{"R99999999999999999999C1", "expected a range"},
                    BadRequest{"R1.5", "expected a range"}, BadRequest{"everything", "not recognised"},
                    BadRequest{"1,2", "item 1 \"1\""}, BadRequest{"NaN", "not recognised"},
                    BadRequest{"All", "not recognised"}, BadRequest{"outer", "expected outer:N"},
                    BadRequest{"outer:0", "above zero"}, BadRequest{"outer:-1", "above zero"},
                    BadRequest{"outer:nan", "above zero"}, BadRequest{"all:3", "expected all"},
                    BadRequest{"every:0", "above zero"}, BadRequest{"every:2.5", "above zero"},
                    BadRequest{"every:99999999999", "above zero"}, BadRequest{"-every:2", "with a minus"},
                    BadRequest{"-spread:2", "with a minus"}, BadRequest{"--plugged", "not recognised"},
                    BadRequest{"spread:27", "asks for 27 tubes, but the rest of the list selects 24"},
                    BadRequest{"R1C1,spread:2", "asks for 2 tubes"}, BadRequest{"zone:1:2:3in", "expected zone:"},
                    BadRequest{"zone:1:2:3:4", "expected zone:"}, BadRequest{"zone:1:2:3:4ft", "expected zone:"},
                    BadRequest{"zone:1:2:3:4:5in", "expected zone:"}, BadRequest{"zone:nan:2:3:4in", "expected zone:"},
                    BadRequest{"zone:2:1:3:4in", "reversed"}, BadRequest{"zone:50:60:0:1in", "no hole"},
                    BadRequest{"leg:cold", "for the cold leg"}, BadRequest{"leg:warm,all", "hot, cold, full"},
                    BadRequest{"-leg:hot", "with a minus"},
                    BadRequest{"all,sheet:0123456789abcdef", "for the sheet 0123456789abcdef"},
                    BadRequest{"-all", "selects no tube"}, BadRequest{"R4C4,-sleeved", "selects no tube"},
                    BadRequest{"stabilised", "selects no tube"}),
    [](const auto& bad) { return "Request" + std::to_string(bad.index); });

TEST(SelectTubes, AHotLegListIsRefusedOnTheColdLeg) {
  SheetDescription description = smallDescription();
  description.leg = Leg::kCold;
  EXPECT_EQ(namesOf(makeSheet(description), "leg:hot,all"),
            "refused: item 1 \"leg:hot\" (character 1): this list is for the hot leg, but the sheet is cold");
}

TEST(SelectTubes, AGapOfATriangularSheetIsExplained) {
  const Sheet sheet = makeSheet(exampleSheets()[4].description);
  const Tube& tube = sheet.tubes[sheet.tubes.size() / 2];
  const std::string reason = namesOf(sheet, tubeName(tube.row, tube.column + 1));
  EXPECT_NE(reason.find("with no hole at this one"), std::string::npos) << reason;
}

TEST(SelectTubes, EmptySheetSelectsNothing) {
  EXPECT_EQ(selectTubes(Sheet{}, "all").status, SelectionStatus::kRefused);
}

TEST(SelectionTerms, HaveUniqueNamesThatAreNoStates) {
  std::set<std::string_view> names;
  for (const SelectionTerm& term : selectionTerms()) {
    EXPECT_TRUE(names.insert(term.name).second) << term.name;
    EXPECT_FALSE(findTubeState(term.name).has_value()) << term.name;
    EXPECT_FALSE(term.meaning.empty());
  }
}

TEST(PeelDepths, TinySheetsAreAllPeriphery) {
  EXPECT_EQ(peelDepths(makeSheet(smallDescription(), {{1, 1, 0, 0.1}})), std::vector<int>{1});
  EXPECT_EQ(peelDepths(makeSheet(smallDescription(), {{1, 1, 0, 0.1}, {1, 2, 0.0254, 0.1}})), (std::vector<int>{1, 1}));
}

}  // namespace
}  // namespace tubeplan::tubesheets
