// The desk of a shift: totals that balance, marks that need a confirmed identity, and undo.
#include "app/outage/job_desk.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <random>

#include "app/outage/job_export.hpp"
#include "app/outage/job_totals.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using tubesheets::Leg;

constexpr const char* kRows = "  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: read-back}\n";
constexpr const char* kFree = "  - {name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: none}\n";

TubeAddress hot(int row, int column) { return {"A", Leg::kHot, row, column}; }

class JobDesk : public JobTest {};

void expectBalanced(const JobTotals& totals) {
  int planned = 0;
  for (const PackageTotal& total : totals.packages) {
    planned += total.counts.planned;
    EXPECT_EQ(total.counts.planned, total.counts.of(ItemStanding::kDone) + total.counts.of(ItemStanding::kExcluded) +
                                        total.counts.unresolved());
    EXPECT_EQ(total.counts.unresolved(), total.counts.of(ItemStanding::kOpen) + total.counts.of(ItemStanding::kQueued) +
                                             total.counts.of(ItemStanding::kHeld));
  }
  EXPECT_EQ(planned, totals.all.planned);
}

TEST_F(JobDesk, PluggedTubesAreExcludedAtBothEnds) {
  JobStore store(made(kRows));
  const JobTotals totals = totalsOf(store);
  ASSERT_EQ(totals.packages.size(), 4u);  // two steam generators with two legs each
  EXPECT_EQ(totals.all.planned, 4 * 15);
  EXPECT_EQ(totals.all.of(ItemStanding::kExcluded), 2);  // R10C20 of A, at its hot and its cold end
  for (const Leg leg : {Leg::kHot, Leg::kCold})
    EXPECT_EQ(requireItem(store, {"A", leg, 10, 20}, "").excluded, "plugged");
  EXPECT_EQ(requireItem(store, {"B", Leg::kHot, 10, 20}, "").standing(), ItemStanding::kOpen);
  expectBalanced(totals);
}

TEST_F(JobDesk, RandomMarksKeepTheBalanceAndUndoRestoresIt) {
  JobStore store(made(kFree));
  std::mt19937_64 random(4);
  std::vector<std::int64_t> marked;
  std::vector<ItemCounts> before;
  const auto items = store.items();
  for (int k = 0; k < 200; ++k) {
    const JobItem& item = items[random() % items.size()];
    const Mark& mark = marks()[random() % marks().size()];
    const ItemCounts counts = totalsOf(store).all;
    try {
      marked.push_back(
          markTube(store, {item.tube, "", std::string(mark.name), {"Maria", "seen again", ""}, std::nullopt}));
      before.push_back(counts);
    } catch (const InputError&) {
      EXPECT_EQ(totalsOf(store).all.with, counts.with);  // a refused mark leaves nothing behind
    }
    expectBalanced(totalsOf(store));
  }
  ASSERT_GT(marked.size(), 100u);
  for (std::size_t k = marked.size(); k-- > 0;) {
    (void)undoMark(store, marked[k], {"Tom", "a test", ""});
    const ItemCounts now = totalsOf(store).all;
    for (const auto standing : {ItemStanding::kOpen, ItemStanding::kQueued, ItemStanding::kHeld, ItemStanding::kDone,
                                ItemStanding::kExcluded})
      EXPECT_EQ(now.of(standing), before[k].of(standing));
  }
  EXPECT_EQ(store.events().size(), 2 * marked.size());
}

TEST_F(JobDesk, AToolEntersOnlyWhereAnotherPersonReadTheTube) {
  JobStore store(made(kRows));
  for (const Mark& mark : marks()) {
    const MarkRequest request{hot(9, 18), "", std::string(mark.name), {"Tom", "a reason", ""}, std::nullopt};
    if (mark.needs_tool) expectSays(messageOf([&] { (void)markTube(store, request); }), "not confirmed");
  }
  const auto readBy = [&](const std::string& who, const std::string& tube) {
    return confirmTube(store, {hot(9, 18), "", tube, std::nullopt, {who, "", ""}});
  };
  const MarkRequest done{hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt};
  EXPECT_TRUE(readBy("Tom", "A/hot/R9C18").is_same);
  expectSays(messageOf([&] { (void)markTube(store, done); }), "another person");
  EXPECT_FALSE(readBy("Maria", "A/hot/R10C18").is_same);
  expectSays(messageOf([&] { (void)markTube(store, done); }), "A/hot/R10C18");
  EXPECT_EQ(totalsOf(store).wrong_tubes.size(), 1u);
  EXPECT_TRUE(readBy("Maria", "A/hot/R9C18").is_same);
  EXPECT_TRUE(totalsOf(store).wrong_tubes.empty());
  const auto event = markTube(store, done);
  (void)undoMark(store, event, {"Tom", "extent too short", ""});
  expectSays(messageOf([&] { (void)markTube(store, done); }),
             "not confirmed");  // each entry needs its own confirmation
}

TEST_F(JobDesk, WhatConfirmCallsConfirmedMayBeMarked) {
  for (const char* required : {"read-back", "position", "none"})
    for (const bool is_read : {true, false}) {
      SCOPED_TRACE(fmt::format("{} {}", required, is_read));
      std::filesystem::remove(folder / "job.record");
      JobStore store(
          made(fmt::format("  - {{name: rows, tubes: R9-11C18-22, tool: bobbin, confirm: {}}}\n", required)));
      const TubeEnd end = store.endOf(hot(9, 18)), wrong = store.endOf(hot(9, 19));
      const auto confirmAs = [&](const TubeEnd& found) {
        ConfirmationRequest request{hot(9, 18), "", is_read ? addressText(found.tube) : "", {}, {"Maria", "", ""}};
        if (!is_read) request.xy = {found.x, found.y};
        return confirmTube(store, request).is_same;
      };
      const auto markDone = [&] { (void)markTube(store, {hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt}); };
      EXPECT_FALSE(confirmAs(wrong));  // a wrong tube is recorded, by whichever method it was found
      EXPECT_EQ(store.events().size(), 1u);
      const std::string other = is_read ? "position" : "read-back";
      if (required == other) {
        expectSays(messageOf([&] { (void)confirmAs(end); }), required);
        EXPECT_EQ(store.events().size(), 1u);
        expectSays(messageOf(markDone), required);
      } else {
        EXPECT_TRUE(confirmAs(end));
        markDone();
        EXPECT_EQ(store.events().size(), 3u);
      }
    }
}

TEST_F(JobDesk, TimesThatHaveNotComeAreRefused) {
  JobStore store(made(kFree));
  const auto event = markTube(store, {hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt});
  const auto in = [](std::chrono::minutes later) {
    const auto at = std::chrono::system_clock::now() + later;
    return EventEntry{"Tom", "late",
                      fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)))};
  };
  const std::function<void(const EventEntry&)> actions[] = {
      [&](const EventEntry& entry) {
        (void)markTube(store, {hot(9, 19), "", "done", entry, std::nullopt});
      },
      [&](const EventEntry& entry) {
        (void)confirmTube(store, {hot(9, 20), "", "A/hot/R9C20", {}, entry});
      },
      [&](const EventEntry& entry) { (void)undoMark(store, event, entry); }};
  for (const auto& action : actions) {
    const std::size_t before = store.events().size();
    for (const int minutes : {12, 60, 24 * 60, 1000 * 24 * 60})
      expectSays(messageOf([&] { action(in(std::chrono::minutes(minutes))); }), "--at");
    EXPECT_EQ(store.events().size(), before);
    action(in(std::chrono::minutes(8)));  // clocks differ
    EXPECT_EQ(store.events().size(), before + 1);
  }
}

TEST_F(JobDesk, NextTakesOpenTubesThenTheQueue) {
  JobStore store(made(kFree));
  const JobPart part{"", "A", Leg::kHot};
  std::set<std::pair<int, int>> visited;
  for (auto next = findNext(store, part); next && next->standing() == ItemStanding::kOpen;
       next = findNext(store, part)) {
    EXPECT_TRUE(visited.insert({next->tube.row, next->tube.column}).second);
    (void)markTube(store, {next->tube, "", visited.size() <= 2 ? "retest" : "done", {"Tom", "", ""}, std::nullopt});
  }
  EXPECT_EQ(visited.size(), 14u);
  EXPECT_EQ(findNext(store, part)->tube, hot(9, 18));  // the first that was queued
  (void)markTube(store, {hot(9, 18), "", "retest", {"Tom", "", ""}, std::nullopt});
  EXPECT_EQ(findNext(store, part)->tube, hot(9, 19));
  (void)markTube(store, {hot(9, 19), "", "done", {"Tom", "", ""}, std::nullopt});
  (void)markTube(store, {hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt});
  EXPECT_FALSE(findNext(store, part));
}

TEST_F(JobDesk, ALaterEventOfAnotherDeskIsNotOverwritten) {
  const std::string path = made(kFree);
  JobStore one(path), other(path);
  const auto seen = findNext(one, {})->last_event;
  (void)markTube(other, {hot(9, 18), "", "obstructed", {"Maria", "", ""}, seen});
  expectSays(messageOf([&] { (void)markTube(one, {hot(9, 18), "", "done", {"Tom", "", ""}, seen}); }), "changed");
  EXPECT_EQ(one.events().size(), 1u);
}

TEST_F(JobDesk, APlugAtOneEndIsReportedUntilTheOtherEndHasOne) {
  JobStore store(made(kFree));
  (void)markTube(store, {hot(9, 18), "", "plugged", {"Tom", "", ""}, std::nullopt});
  ASSERT_EQ(totalsOf(store).plugged_at_one_end.size(), 1u);
  EXPECT_EQ(totalsOf(store).plugged_at_one_end.front(), hot(9, 18));
  (void)markTube(store, {{"A", Leg::kCold, 9, 19}, "", "plugged", {"Tom", "", ""}, std::nullopt});  // a wrong tube
  EXPECT_EQ(totalsOf(store).plugged_at_one_end.size(), 2u);
  (void)markTube(store, {{"A", Leg::kCold, 9, 18}, "", "plugged", {"Tom", "", ""}, std::nullopt});
  EXPECT_EQ(totalsOf(store).plugged_at_one_end.size(), 1u);
}

TEST_F(JobDesk, AnEndThatWasPluggedIsNeitherNextNorLeftInOtherPackages) {
  JobStore store(made(std::string(kFree) + "  - {name: again, tubes: R9C18-19, tool: bobbin, confirm: none}\n"));
  const JobPart again{"again", "A", Leg::kHot};
  EXPECT_EQ(itemsToVisit(store.items(), again).size(), 2u);
  (void)markTube(store, {hot(9, 18), "rows", "plugged", {"Tom", "", ""}, std::nullopt});
  const auto items = store.items();
  ASSERT_EQ(itemsToVisit(items, again).size(), 1u);
  EXPECT_EQ(findNext(items, again)->tube, hot(9, 19));
  const JobTotals totals = totalsOf(store);
  ASSERT_EQ(totals.plugged_in_the_meantime.size(), 1u);  // otherwise the totals would wait for it without notice
  EXPECT_EQ(totals.plugged_in_the_meantime.front().package, "again");
  (void)markTube(store, {hot(9, 18), "again", "excluded", {"Tom", "plugged", ""}, std::nullopt});
  EXPECT_TRUE(totalsOf(store).plugged_in_the_meantime.empty());
  expectBalanced(totalsOf(store));
}

TEST_F(JobDesk, ShiftsCountWhatTheyFinished) {
  JobStore store(made(kFree));
  const auto markAt = [&](int column, const char* at) {
    (void)markTube(store, {hot(9, column), "", "done", {"Tom", "", at}, std::nullopt});
  };
  markAt(18, "2025-04-02T06:00:00Z");
  markAt(19, "2025-04-02T17:59:59Z");
  markAt(20, "2025-04-02T18:00:00Z");
  markAt(21, "2025-04-03T05:59:59Z");
  const auto shifts = totalsOf(store).shifts;
  ASSERT_EQ(shifts.size(), 2u);
  for (const ShiftBalance& shift : shifts) {
    EXPECT_EQ(shift.shift.date, "2025-04-02");
    EXPECT_EQ(shift.done, 2);
  }
  for (const char* at : {"yesterday", "2025-02-30T06:00:00Z", "2025-02-28T24:00:00Z", "2025-02-28T23:59:60Z",
                         "1970-01-01T00:00:00Z", "9999-01-01T00:00:00Z"}) {
    SCOPED_TRACE(at);
    expectSays(messageOf([&] { markAt(22, at); }), "--at");
  }
}

TEST_F(JobDesk, TheShiftsAddUpToTheTotalHoweverOftenATubeIsMarked) {
  JobStore store(made(kFree));
  const auto markAt = [&](int column, const char* as, const char* at) {
    (void)markTube(store, {hot(9, column), "", as, {"Tom", "again", at}, std::nullopt});
  };
  markAt(18, "done", "2025-04-02T07:00:00Z");
  markAt(18, "done", "2025-04-02T08:00:00Z");
  markAt(19, "done", "2025-04-02T09:00:00Z");
  markAt(18, "done", "2025-04-02T20:00:00Z");
  markAt(19, "retest", "2025-04-02T21:00:00Z");
  const JobTotals totals = totalsOf(store);
  ASSERT_EQ(totals.shifts.size(), 2u);
  EXPECT_EQ(totals.shifts[0].done, 2);
  EXPECT_EQ(totals.shifts[0].reopened, 0);
  EXPECT_EQ(totals.shifts[1].done, 0);
  EXPECT_EQ(totals.shifts[1].reopened, 1);
  int net = 0;
  for (const ShiftBalance& shift : totals.shifts) net += shift.done - shift.reopened;
  EXPECT_EQ(net, totals.all.of(ItemStanding::kDone));
}

TEST_F(JobDesk, AShiftsBalanceIsThatOfTheItemsAsTheyStoodAtItsEnd) {
  JobStore store(made(kFree));
  std::mt19937 random(7);
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  for (int k = 0; k < 120; ++k) {
    const std::string at = fmt::format("2025-04-{:02}T{:02}:{:02}:00Z", 2 + below(4), below(24), below(60));
    const auto events = store.events();
    try {
      if (below(4) == 0 && !events.empty())
        (void)undoMark(store, events[static_cast<std::size_t>(below(static_cast<int>(events.size())))].id,
                       {"Tom", "undone", at});
      else
        (void)markTube(store,
                       {hot(9, 18 + below(5)), "", below(3) ? "done" : "retest", {"Tom", "again", at}, std::nullopt});
    } catch (const InputError&) {  // not every event can be undone
    }
  }
  const auto items = store.items();
  const auto events = store.events();
  const auto& shifts = store.job().shifts;
  int net = 0;
  for (const ShiftBalance& balance : balancesOf(items, events, shifts)) {
    const ItemCounts then = countsOf(itemsAt(items, events, endOf(balance.shift, shifts)));
    EXPECT_EQ(balance.at_end.planned, then.planned);
    for (const auto standing : {ItemStanding::kOpen, ItemStanding::kQueued, ItemStanding::kHeld, ItemStanding::kDone})
      EXPECT_EQ(balance.at_end.of(standing), then.of(standing)) << balance.shift.date << balance.shift.name;
    net += balance.done - balance.reopened;
  }
  EXPECT_EQ(net, totalsOf(store).all.of(ItemStanding::kDone));
  EXPECT_GT(events.size(), 80u);
}

TEST_F(JobDesk, APersonIsTheSameHoweverTheNameIsWritten) {
  JobStore store(made(kRows));
  (void)confirmTube(store, {hot(9, 18), "", "A/hot/R9C18", std::nullopt, {"Tom", "", ""}});
  for (const char* who : {"Tom", "tom", "TOM", " Tom ", "Tom.", "T o m"}) {
    SCOPED_TRACE(who);
    expectSays(messageOf([&] {
                 (void)markTube(store, {hot(9, 18), "", "done", {who, "", ""}, std::nullopt});
               }),
               "another person");
  }
  for (const char* who : {"", " ", "\t", "--", "To\nm"}) {
    SCOPED_TRACE(who);
    expectSays(messageOf([&] {
                 (void)confirmTube(store, {hot(9, 18), "", "A/hot/R9C18", std::nullopt, {who, "", ""}});
               }),
               "--by");
  }
}

TEST_F(JobDesk, APartOfTheJobMustExist) {
  JobStore store(made(kRows));
  EXPECT_NO_THROW(requirePart(store.job(), {"", "A", Leg::kCold}));
  expectSays(messageOf([&] { requirePart(store.job(), {"", "A", Leg::kFull}); }), "cold or hot");
}

TEST_F(JobDesk, AConfirmationFromBeforeAnUndoConfirmsNothing) {
  JobStore store(made(kRows));
  const auto read = [&] { (void)confirmTube(store, {hot(9, 18), "", "A/hot/R9C18", std::nullopt, {"Maria", "", ""}}); };
  const MarkRequest done{hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt};
  read();
  const auto event = markTube(store, done);
  read();
  (void)undoMark(store, event, {"Tom", "extent too short", ""});
  expectSays(messageOf([&] { (void)markTube(store, done); }), "not confirmed");
}

TEST_F(JobDesk, TheLogRefusesToForget) {
  const std::string path = made(kFree);
  JobStore store(path);
  (void)markTube(store, {hot(9, 18), "", "done", {"Tom", "", ""}, std::nullopt});
  Database database(path, Database::Mode::kOpen);
  EXPECT_ANY_THROW(database.execute("DELETE FROM event"));
  EXPECT_ANY_THROW(database.execute("UPDATE event SET who = 'Maria'"));
  EXPECT_ANY_THROW(database.execute("DELETE FROM item"));
  EXPECT_EQ(store.events().size(), 1u);
}

TEST_F(JobDesk, AListKeepsItsColumnsAndComments) {
  const std::string list =
      "# from the analysts\nsg,leg,row,column,code,remark\nA,hot,9,18,RRT,\"wear, 03H\"\nA,hot,9,19,RRT,noise\n";
  (void)write("list.csv", list);
  JobStore store(made("  - {name: retests, tubes: list.csv, tool: bobbin, confirm: none}\n"));
  EXPECT_EQ(totalsOf(store).all.planned, 2);  // only the leg that the list names
  (void)markTube(store, {hot(9, 18), "", "done", {"Tom", "", "2025-04-02T06:00:00Z"}, std::nullopt});
  const std::string csv = packageCsv(store, "retests", "A", Leg::kHot);
  EXPECT_EQ(csv,
            "# from the analysts\nsg,leg,row,column,code,remark,standing,mark,marked_by,marked_at,visit\n"
            "A,hot,9,18,RRT,\"wear, 03H\",done,done,Tom,2025-04-02T06:00:00Z,\nA,hot,9,19,RRT,noise,open,,,,\n");
}

}  // namespace
}  // namespace tubeplan::app
