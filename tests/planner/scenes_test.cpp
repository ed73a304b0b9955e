// The shipped scenes that are harder than the mock-up: their tubes are planned and proved, or refused with a reason.
#include <gtest/gtest.h>

#include "planner/verification/plan_checks.hpp"
#include "tests/planner/verification/stated_plan.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using testing::statedPlan;

struct ScenePlan {
  Workcell cell;
  std::size_t requested;
  VisitPlan plan;
};

ScenePlan planned(const std::string& scene, const std::string& tubes) {
  ScenePlan result{testing::mockup("scenes/" + scene + ".yaml"), 0, {}};
  const auto list = testing::tubesOf(result.cell, tubes);
  result.requested = list.size();
  result.plan = planVisits(result.cell, list);
  return result;
}

void expectSound(const ScenePlan& scene) {
  ASSERT_EQ(scene.plan.status, VisitPlanStatus::kPlanned) << scene.plan.reason;
  EXPECT_EQ(scene.plan.visits.size() + scene.plan.unreachable.size(), scene.requested);
  for (const auto& missed : scene.plan.unreachable) EXPECT_FALSE(missed.reason.empty());
  const PlanCheck check = checkPlan(scene.cell, statedPlan(scene.cell, scene.plan));
  EXPECT_EQ(check.status, PlanCheckStatus::kProved) << check.findings.front();
}

int countReasons(const VisitPlan& plan, const std::string& part) {
  return static_cast<int>(std::ranges::count_if(
      plan.unreachable, [&](const auto& missed) { return missed.reason.find(part) != std::string::npos; }));
}

TEST(Scenes, ABlockedManwaySideLeavesMostTubes) {
  const auto scene = planned("blocked-manway", "every:60");
  expectSound(scene);
  EXPECT_GT(scene.plan.visits.size(), 70u);
}

TEST(Scenes, AHangingNozzleDamIsGoneRoundAndNamed) {
  const auto scene = planned("moved-nozzle-dam", "every:60");
  expectSound(scene);
  EXPECT_GT(countReasons(scene.plan, "hanging-nozzle-dam"), 3);
  EXPECT_GT(scene.plan.visits.size(), 40u);
}

TEST(Scenes, AStayCylinderPartsTheSpaceAndWhatIsApartIsSaid) {
  const auto scene = planned("stay-cylinder", "every:60");
  expectSound(scene);
  EXPECT_GT(countReasons(scene.plan, "stay-cylinder"), 10);
  EXPECT_GT(countReasons(scene.plan, "the search did not connect it"), 0);
  EXPECT_EQ(countReasons(scene.plan, "no path from the tube before it"), 0);
}

TEST(Scenes, UpsideDownTheArmSagsTowardsTheSheetAndStillCentres) {
  const auto scene = planned("upside-down", "every:60");
  expectSound(scene);
  EXPECT_GT(scene.plan.visits.size(), 75u);
  const Workcell upright = testing::mockup("scenes/stay-cylinder.yaml");
  EXPECT_EQ(scene.cell.arm.gravity_W, -upright.arm.gravity_W);
  const auto& q = scene.plan.visits.front().branch.q;
  Workcell turned = scene.cell;
  turned.arm.gravity_W = upright.arm.gravity_W;
  EXPECT_LT(testing::deflectedTip(turned, q).z(), testing::deflectedTip(scene.cell, q).z() - 0.5 * kInch);
}

}  // namespace
}  // namespace tubeplan::planner
