// Tests of a plan's cache as text of which only some entries are read.
#include "app/formats/checkpoint/plan_cache_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/formats/cell/workcell.hpp"
#include "app/formats/checkpoint/plan_cache_json.hpp"
#include "planner/visit_plan.hpp"
#include "tests/app/test_files.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {
namespace {

planner::PlanCache plannedCache() {
  const auto cell = workcellOf(readCell((shippedCells() / "mockup.yaml").string()), "test the memory");
  const auto tubes = tubesheets::selectTubes(cell.sheet, "R39C58,R3C10,R10C95,R20C40,R30C70,R45C50").tube_indices;
  planner::PlanCache cache;
  EXPECT_EQ(planner::planVisits(cell, tubes, {}, {}, cache).status, planner::VisitPlanStatus::kPlanned);
  return cache;
}

TEST(PlanCacheText, IsTheSameTextHoweverMuchOfItIsRead) {
  const planner::PlanCache cache = plannedCache();
  const std::string text = cacheJson(cache).dump();
  const PlanCacheText entries(text);
  EXPECT_EQ(PlanCacheText().with(cache), text);
  EXPECT_EQ(entries.with(entries.readAll()), text);
  EXPECT_EQ(entries.with(entries.read({cache.visiting_order[1]})), text);
  EXPECT_EQ(cacheJson(entries.readAll()).dump(), text);
  EXPECT_EQ(entries.visitingOrder(), cache.visiting_order);
}

TEST(PlanCacheText, GivesTheEntriesOfTheTubesThatAreAskedFor) {
  const planner::PlanCache cache = plannedCache();
  const PlanCacheText entries(cacheJson(cache).dump());
  const int a = cache.visiting_order[1], b = cache.visiting_order[2];
  const planner::PlanCache some = entries.read({a, b});
  ASSERT_EQ(some.reach.size(), 2u);
  EXPECT_EQ(some.reach.at(a).branches.front().q, cache.reach.at(a).branches.front().q);
  EXPECT_FALSE(some.travels.empty());
  for (const auto& [ends, plan] : some.travels) EXPECT_EQ(plan.waypoints, cache.travels.at(ends).waypoints);
  for (const auto& [ends, proof] : some.proofs) EXPECT_EQ(proof.margin, cache.proofs.at(ends).margin);
  EXPECT_EQ(some.visiting_order, cache.visiting_order);
  EXPECT_EQ(some.visiting_branches, cache.visiting_branches);
  EXPECT_EQ(some.bound.lower_bound, cache.bound.lower_bound);
}

TEST(PlanCacheText, WithoutEndsHasNoTravelFromThem) {
  planner::PlanCache cache = plannedCache();
  const planner::MotionEnds from_start{{-1, 0}, {cache.visiting_order.front(), 0}};
  cache.travels[from_start] = cache.travels.begin()->second;
  cache.proofs[from_start] = {};
  PlanCacheText entries(cacheJson(cache).dump());
  EXPECT_TRUE(entries.readAll().travels.contains(from_start));
  entries.dropEnds();
  EXPECT_FALSE(entries.readAll().travels.contains(from_start));
  EXPECT_FALSE(entries.readAll().proofs.contains(from_start));
  EXPECT_EQ(entries.readAll().travels.size(), cache.travels.size() - 1);
}

TEST(PlanCacheText, RefusesAnyOtherText) {
  const std::string text = cacheJson(plannedCache()).dump();
  for (const std::string& damaged :
       {std::string(), std::string("[]"), std::string("{"), std::string("{}x"), text.substr(0, text.size() / 2),
        text + "}", "{ " + text.substr(1), std::string(R"({"reach":[{}]})"),
        std::string(R"({"travels":[{"ends":[1]}]})"), std::string(R"({"reach":{"tube":1}})"),
        std::string(R"({"a":1 "b":2})"), std::string("{\"a")})
    EXPECT_THROW((void)PlanCacheText(damaged).readAll(), nlohmann::json::exception) << damaged.substr(0, 40);
}

}  // namespace
}  // namespace tubeplan::app
