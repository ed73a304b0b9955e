// The hand-over of a shift: totals must balance in every row, the standing must be that at the end of the shift,
// warnings must come first, and names must never become markup.
#include "app/outage/hand_over.hpp"

#include <nlohmann/json.hpp>

#include "app/outage/hand_over_json.hpp"
#include "app/outage/job_desk.hpp"
#include "app/report/outage_report.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;
using tubesheets::Leg;

constexpr const char* kRowsAndList =
    "  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: none}\n"
    "  - {name: list, tubes: list.csv, tool: bobbin, confirm: none}\n";
constexpr const char* kZonedList = "sg,leg,row,column,zone\nA,hot,9,18,inner\nA,hot,9,19,outer\n";

class HandOverOf : public JobTest {
 protected:
  std::string record() {
    (void)write("list.csv", kZonedList);
    return made(kRowsAndList);
  }
};

std::int64_t mark(JobStore& store, int column, const char* as, const std::string& at, const EventEntry& of) {
  return markTube(store, {{"A", Leg::kHot, 10, column}, "", as, {of.person, of.reason, at}, std::nullopt});
}

void expectBalanced(const ItemCounts& counts, int planned) {
  EXPECT_EQ(counts.planned, planned);
  EXPECT_EQ(counts.planned, counts.of(ItemStanding::kDone) + counts.of(ItemStanding::kExcluded) + counts.unresolved());
}

TEST_F(HandOverOf, EveryTotalBalancesAndHasAllItems) {
  JobStore store(record());
  (void)mark(store, 18, "done", "2025-04-02T07:00:00Z", {"Tom", "", ""});
  (void)mark(store, 19, "retest", "2025-04-02T07:01:00Z", {"Tom", "", ""});
  const HandOver of = handOverOf(store, {});
  ASSERT_EQ(of.totals.size(), 4u);
  EXPECT_EQ(of.totals.back().by, "zone");
  for (const TotalsBy& by : of.totals) {
    int planned = 0;
    for (const auto& [name, counts] : by.rows) {
      planned += counts.planned;
      expectBalanced(counts, counts.planned);
    }
    EXPECT_EQ(planned, 4 * 15 + 2) << by.by;
  }
  std::map<std::string, int> zones;
  for (const auto& [name, counts] : of.totals.back().rows) zones[name] = counts.planned;
  EXPECT_EQ(zones, (std::map<std::string, int>{{"inner", 2}, {"no zone", 58}, {"outer", 2}}));
}

TEST_F(HandOverOf, AShiftEndsWithWhatStoodThen) {
  JobStore store(record());
  const auto first = mark(store, 18, "done", "2025-04-02T17:59:59Z", {"Tom", "", ""});
  (void)mark(store, 19, "done", "2025-04-02T18:00:00Z", {"Maria", "", ""});
  (void)mark(store, 22, "excluded", "2025-04-03T05:00:00Z", {"Maria", "bent", ""});
  (void)undoMark(store, first, {"Maria", "extent too short", "2025-04-03T05:59:00Z"});
  const HandOver of = handOverOf(store, {});
  ASSERT_EQ(of.shifts.size(), 2u);
  EXPECT_EQ(of.shifts[0].shift, (ShiftOfDay{"2025-04-02", "day"}));
  EXPECT_EQ(of.shifts[0].at_end.of(ItemStanding::kDone), 1);  // the undo came later
  EXPECT_EQ(of.shifts[0].done, 1);
  EXPECT_EQ(of.shifts[1].done, 1);
  EXPECT_EQ(of.shifts[1].reopened, 1);
  EXPECT_EQ(of.shifts[1].at_end.of(ItemStanding::kDone), 1);
  EXPECT_EQ(of.shifts[1].marks, 2);
  for (const ShiftBalance& balance : of.shifts) expectBalanced(balance.at_end, 62);
  EXPECT_EQ(of.shift, (ShiftOfDay{"2025-04-02", "night"}));
  EXPECT_EQ(of.events.size(), 3u);
  ASSERT_EQ(of.people.size(), 1u);
  EXPECT_EQ(of.people[0].person, "Maria");
  EXPECT_EQ(of.people[0].undone, 1);
}

TEST_F(HandOverOf, AnEarlierShiftIsReportedAsItEnded) {
  JobStore store(record());
  (void)mark(store, 18, "done", "2025-04-02T07:00:00Z", {"Tom", "", ""});
  const auto first = mark(store, 19, "done", "2025-04-02T09:00:00Z", {"Tom", "", ""});
  const HandOver then = handOverOf(store, {"day", "2025-04-02"});
  (void)undoMark(store, first, {"Maria", "extent too short", "2025-04-02T22:00:00Z"});
  (void)mark(store, 18, "retest", "2025-04-02T23:00:00Z", {"Maria", "noisy", ""});
  const HandOver now = handOverOf(store, {"day", "2025-04-02"});
  EXPECT_EQ(now.total.with, then.total.with);
  EXPECT_EQ(now.total.of(ItemStanding::kDone), 2);
  EXPECT_TRUE(now.retests.empty());
  EXPECT_EQ(now.later_events, 2);
  EXPECT_EQ(then.later_events, 0);
  ASSERT_EQ(now.people.size(), 1u);
  EXPECT_EQ(now.people[0].marks.at("done"), 2);
  EXPECT_EQ(handOverOf(store, {}).retests.size(), 1u);
}

TEST_F(HandOverOf, TheShiftIsTheLatestThatFits) {
  JobStore store(record());
  EXPECT_FALSE(handOverOf(store, {}).shift);
  EXPECT_FALSE(handOverOf(store, {"day", ""}).shift);
  (void)mark(store, 18, "done", "2025-04-02T07:00:00Z", {"Tom", "", ""});
  (void)mark(store, 19, "done", "2025-04-03T07:00:00Z", {"Tom", "", ""});
  (void)mark(store, 21, "done", "2025-04-03T02:00:00Z", {"Tom", "", ""});  // recorded later, of the night before
  EXPECT_EQ(handOverOf(store, {}).shift, (ShiftOfDay{"2025-04-03", "day"}));
  EXPECT_EQ(handOverOf(store, {"night", ""}).shift, (ShiftOfDay{"2025-04-02", "night"}));
  EXPECT_EQ(handOverOf(store, {"day", "2025-04-02"}).events.size(), 1u);
  const HandOver quiet = handOverOf(store, {"day", "2025-04-01"});
  EXPECT_EQ(quiet.shift, (ShiftOfDay{"2025-04-01", "day"}));
  EXPECT_TRUE(quiet.events.empty());
  EXPECT_TRUE(quiet.people.empty());
  expectSays(messageOf([&] { (void)handOverOf(store, {"nigth", ""}); }), "did you mean 'night'");
  for (const char* date : {"2025-02-29", "yesterday", "2025-4-2", "2025-04-02T"})
    expectSays(messageOf([&] { (void)handOverOf(store, {"day", date}); }), "--date");
}

TEST_F(HandOverOf, WhatMustBeKnownIsListedWithItsReasons) {
  JobStore store(record());
  (void)mark(store, 18, "obstructed", "2025-04-02T07:00:00Z", {"Tom", "dent at 03H", ""});
  (void)mark(store, 19, "obstructed", "2025-04-02T07:01:00Z", {"Tom", "dent at 03H", ""});
  (void)mark(store, 21, "restricted", "2025-04-02T07:02:00Z", {"Tom", "", ""});
  (void)mark(store, 22, "retest", "2025-04-02T07:03:00Z", {"Maria", "noise", ""});
  const EventEntry seen{"Maria", "", "2025-04-02T07:04:00Z"};
  (void)confirmTube(store, {{"A", Leg::kHot, 11, 18}, "", "A/hot/R11C19", std::nullopt, seen});
  const json page = handOverJson(store, handOverOf(store, {}), {}, "2025-04-02T18:00:00Z");
  ASSERT_EQ(page["held"].size(), 2u);
  EXPECT_EQ(page["held"][0]["reason"], "obstructed: dent at 03H");
  EXPECT_EQ(page["held"][0]["tubes"], (json{"A/hot/R10C18 rows", "A/hot/R10C19 rows"}));
  EXPECT_EQ(page["held"][1]["reason"], "restricted, no reason stated");
  for (const json& held : page["held"])
    for (const json& tube : held["tubes"]) expectSays(handOverText(page), tube.get<std::string>());
  ASSERT_EQ(page["retests"].size(), 1u);
  EXPECT_EQ(page["retests"][0]["reason"], "noise");
  EXPECT_EQ(page["wrong_tubes"].size(), 1u);
  ASSERT_EQ(page["wrong"].size(), 1u);
  EXPECT_EQ(page["wrong"][0]["is_resolved"], false);
  (void)confirmTube(store, {{"A", Leg::kHot, 11, 18}, "", "A/hot/R11C18", std::nullopt, seen});
  const json later = handOverJson(store, handOverOf(store, {}), {}, "");
  EXPECT_TRUE(later["wrong_tubes"].empty());
  EXPECT_EQ(later["wrong"][0]["is_resolved"], true);
}

TEST_F(HandOverOf, TheMapsHaveOneLetterForEachHole) {
  JobStore store(record());
  (void)mark(store, 18, "done", "2025-04-02T07:00:00Z", {"Tom", "", ""});
  (void)mark(store, 19, "obstructed", "2025-04-02T07:00:00Z", {"Tom", "", ""});
  const json page = handOverJson(store, handOverOf(store, {}), {}, "");
  ASSERT_EQ(page["legs"].size(), 4u);
  for (const json& leg : page["legs"]) {
    EXPECT_EQ(leg["sheet"]["viewed_from"], "below");
    EXPECT_TRUE(leg["time_left_s"].is_null());  // no plan yet
    for (const json& of : leg["standings"]) EXPECT_EQ(of["of"].get<std::string>().size(), leg["sheet"]["holes"].size());
  }
  const std::string letters = page["legs"][0]["standings"][0]["of"];
  EXPECT_EQ(std::ranges::count(letters, 'd'), 1);
  EXPECT_EQ(std::ranges::count(letters, 'h'), 1);
  EXPECT_EQ(std::ranges::count(letters, 'x'), 1);
  EXPECT_EQ(std::ranges::count(letters, 'o'), 12);
}

TEST_F(HandOverOf, NamesAreNoMarkup) {
  JobStore store(record());
  const std::string name = "</script><script>alert('\"x\"')</script>";
  (void)mark(store, 18, "excluded", "2025-04-02T07:00:00Z", {name, name, ""});
  const json page = handOverJson(store, handOverOf(store, {}), {}, "");
  EXPECT_EQ(page["people"][0]["who"], name);
  EXPECT_EQ(renderHandOverReport(page).find("<script>alert"), std::string::npos);
}

TEST_F(HandOverOf, ARecordWithoutLooksOfItsSheetsIsDrawnFromBelow) {
  const std::string path = record();
  Database(path, Database::Mode::kOpen).execute("DELETE FROM job WHERE key LIKE 'look %'");
  JobStore store(path);
  const json page = handOverJson(store, handOverOf(store, {}), {}, "");
  EXPECT_EQ(page["legs"][0]["sheet"]["viewed_from"], "below");
  EXPECT_TRUE(page["shift"].is_null());
}

}  // namespace
}  // namespace tubeplan::app
