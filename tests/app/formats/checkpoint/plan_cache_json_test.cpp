// Tests of the planning cache as JSON: every number must be kept to the last bit, including NaN and infinities.
#include "app/formats/checkpoint/plan_cache_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/formats/cell/workcell.hpp"
#include "planner/visit_plan.hpp"
#include "tests/app/test_files.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {
namespace {

TEST(PlanCacheJson, ComesBackTheSame) {
  const auto cell = workcellOf(readCell((shippedCells() / "mockup.yaml").string()), "test the memory");
  // One of the six tubes is out of reach.
  const auto tubes = tubesheets::selectTubes(cell.sheet, "R39C58,R3C10,R10C95,R20C40,R30C70,R45C50").tube_indices;
  planner::PlanCache cache;
  ASSERT_EQ(planner::planVisits(cell, tubes, {}, {}, cache).status, planner::VisitPlanStatus::kPlanned);
  ASSERT_EQ(cache.reach.size(), 6u);
  const std::string text = cacheJson(cache).dump();
  const planner::PlanCache again = cacheFrom(nlohmann::json::parse(text));
  EXPECT_EQ(cacheJson(again).dump(), text);
  for (const auto& [tube, reach] : cache.reach) {
    const auto& other = again.reach.at(tube);
    EXPECT_EQ(other.status, reach.status);
    EXPECT_EQ(other.reason, reach.reason);
    ASSERT_EQ(other.branches.size(), reach.branches.size());
    for (std::size_t k = 0; k < reach.branches.size(); ++k) {
      EXPECT_EQ(other.branches[k].q, reach.branches[k].q);
      EXPECT_EQ(other.branches[k].approach, reach.branches[k].approach);
      EXPECT_EQ(other.branches[k].tilt, reach.branches[k].tilt);
    }
  }
  for (const auto& [ends, plan] : cache.travels) EXPECT_EQ(again.travels.at(ends).waypoints, plan.waypoints);
  EXPECT_EQ(again.visiting_order, cache.visiting_order);
  EXPECT_EQ(again.orders.size(), cache.orders.size());
}

TEST(PlanCacheJson, KeepsNumbersThatAreNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  planner::PlanCache cache;
  cache.proofs[{{1, 0}, {2, 1}}] = {kInfinity, {-kInfinity, 0.1, "forearm", "divider \"hot\""}};
  const auto again = cacheFrom(nlohmann::json::parse(cacheJson(cache).dump()));
  const auto& proof = again.proofs.at({{1, 0}, {2, 1}});
  EXPECT_EQ(proof.margin, kInfinity);
  EXPECT_EQ(proof.tightest.distance, -kInfinity);
  EXPECT_EQ(proof.tightest.margin, 0.1);
  EXPECT_EQ(proof.tightest.other, "divider \"hot\"");
  EXPECT_TRUE(std::isnan(proof.tightest.point_W.x()));
}

}  // namespace
}  // namespace tubeplan::app
