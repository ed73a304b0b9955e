// A plan's memory in its file: every number to the last bit, those that are not finite among them.
#include "app/files/checkpoint/plan_memory_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/workcell.hpp"
#include "planner/visit_plan.hpp"
#include "tests/app/test_files.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {
namespace {

TEST(PlanMemoryJson, ComesBackTheSame) {
  const auto cell = workcellOf(readCell((shippedCells() / "mockup.yaml").string()), "test the memory");
  // One of these is out of reach.
  const auto tubes = tubesheets::selectTubes(cell.sheet, "R39C58,R3C10,R10C95,R20C40,R30C70,R45C50").tube_indices;
  planner::PlanMemory memory;
  ASSERT_EQ(planner::planVisits(cell, tubes, {}, {}, memory).status, planner::VisitPlanStatus::kPlanned);
  ASSERT_EQ(memory.reach.size(), 6u);
  const std::string text = memoryJson(memory).dump();
  const planner::PlanMemory again = memoryFrom(nlohmann::json::parse(text));
  EXPECT_EQ(memoryJson(again).dump(), text);
  for (const auto& [tube, reach] : memory.reach) {
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
  for (const auto& [ends, plan] : memory.travels) EXPECT_EQ(again.travels.at(ends).waypoints, plan.waypoints);
  EXPECT_EQ(again.visiting_order, memory.visiting_order);
  EXPECT_EQ(again.orders.size(), memory.orders.size());
}

TEST(PlanMemoryJson, KeepsNumbersThatAreNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  planner::PlanMemory memory;
  memory.proofs[{{1, 0}, {2, 1}}] = {kInfinity, {-kInfinity, 0.1, "forearm", "divider \"hot\""}};
  const auto again = memoryFrom(nlohmann::json::parse(memoryJson(memory).dump()));
  const auto& proof = again.proofs.at({{1, 0}, {2, 1}});
  EXPECT_EQ(proof.margin, kInfinity);
  EXPECT_EQ(proof.tightest.distance, -kInfinity);
  EXPECT_EQ(proof.tightest.margin, 0.1);
  EXPECT_EQ(proof.tightest.other, "divider \"hot\"");
  EXPECT_TRUE(std::isnan(proof.tightest.point_W.x()));
}

}  // namespace
}  // namespace tubeplan::app
