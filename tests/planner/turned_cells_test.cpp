// Equivalent descriptions of one task have the same plan, and tilted tasks can be planned: the short form of
// studies/turned_cells.cpp.
#include "tests/planner/turned_cells.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/planner/reach/brute_reach.hpp"
#include "tests/planner/verification/stated_plan.hpp"

namespace tubeplan::planner {
namespace {

using testing::mockup;

std::set<int> tubesIn(const VisitPlan& plan) {
  std::set<int> tubes;
  for (const auto& visit : plan.visits) tubes.insert(visit.tube);
  return tubes;
}

struct Shipped {
  const char* file;
  /// Relative difference of travel times allowed between base frames. An arm with more joints than a goal requires has
  /// a continuous family of postures; rounding decides which of its samples are considered equal.
  double tolerance;
};

class TurnedCells : public ::testing::TestWithParam<Shipped> {};
INSTANTIATE_TEST_SUITE_P(Shipped, TurnedCells,
                         ::testing::Values(Shipped{"mockup.yaml", 1e-6}, Shipped{"column.yaml", 1e-6},
                                           Shipped{"puma.yaml", 0.01}),
                         [](const auto& shipped) { return std::string(shipped.param.file).substr(0, 4); });

TEST_P(TurnedCells, TheSameTaskInOtherUnitsTurnedOrFromAnotherFrameHasTheSamePlan) {
  const auto [name, tolerance] = GetParam();
  const std::string file = name;
  std::mt19937_64 generator(3);
  const Workcell cell = mockup(file);
  const std::vector<int> tubes = testing::tubesOf(cell, "spread:8");
  const VisitPlan first = planVisits(cell, tubes);
  ASSERT_GE(first.visits.size(), 3U);
  for (const Workcell& same :
       {testing::inUnitOf(file, "m"), testing::inUnitOf(file, "in"), testing::turnedAboutTheNormal(file, 2.2),
        testing::fromAnotherBaseFrame(cell, generator)}) {
    const VisitPlan plan = planVisits(same, tubes);
    EXPECT_EQ(tubesIn(plan), tubesIn(first));
    EXPECT_NEAR(plan.travel_time, first.travel_time, tolerance * first.travel_time);
    EXPECT_NEAR(plan.lower_bound, first.lower_bound, tolerance * first.lower_bound);
    EXPECT_EQ(checkPlan(same, testing::statedPlan(same, plan)).status, PlanCheckStatus::kProved);
  }
}

TEST_P(TurnedCells, WhatLeansByDegreesOrHangsUpsideDownIsPlannedAndProvedAndNoTubeIsRefusedThatRandomStartsReach) {
  const Workcell cell = mockup(GetParam().file);
  const std::vector<int> tubes = testing::tubesOf(cell, "spread:8");
  for (const Workcell& askew : {testing::withBaseLeaning(cell, 2.5, 1), testing::withGravityLeaning(cell, 3, -2),
                                testing::withGravityLeaning(cell, 180, 0)}) {
    const VisitPlan plan = planVisits(askew, tubes);
    ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned) << plan.reason;
    const PlanCheck check = checkPlan(askew, testing::statedPlan(askew, plan));
    EXPECT_EQ(check.status, PlanCheckStatus::kProved) << (check.findings.empty() ? "" : check.findings.front());
    const ArmClearance clearance(askew);
    for (const int tube : tubes) {
      const TubeReach reach = reachTube(clearance, tube);
      if (reach.status != ReachStatus::kReachable) {
        EXPECT_FALSE(testing::isReachedByBruteForce(clearance, tube, 40)) << tube << ": " << reach.reason;
      }
    }
  }
}

}  // namespace
}  // namespace tubeplan::planner
