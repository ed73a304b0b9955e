// Plans that begin where the arm stands at a hole: the tool goes straight down before it travels.
#include "planner/departure.hpp"

#include <gtest/gtest.h>

#include "tests/planner/verification/stated_plan.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using testing::deflectedTip;
using testing::holeOf;
using testing::mockup;
using testing::tubesOf;

TubeBranch branchAt(const Workcell& cell, int tube) {
  const TubeReach reach = reachTube(ArmClearance(cell), tube);
  return reach.branches.at(0);
}

VisitPlan planFrom(const Workcell& cell, const std::vector<int>& tubes, const Eigen::VectorXd& start) {
  VisitPlanOptions options;
  options.conditions.start = start;
  return planVisits(cell, tubes, options);
}

class StandsAtAHole : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Arms, StandsAtAHole, ::testing::Values("mockup.yaml", "puma.yaml", "column.yaml"),
                         [](const auto& cell) { return std::string(cell.param, std::strcspn(cell.param, ".")); });

TEST_P(StandsAtAHole, TheToolGoesStraightDownAndThePlanIsProved) {
  const Workcell cell = mockup(GetParam());
  const auto tubes = tubesOf(cell, "spread:12");
  const VisitPlan first_plan = planVisits(cell, tubes);
  ASSERT_EQ(first_plan.status, VisitPlanStatus::kPlanned);
  const int departed = first_plan.visits.front().tube;
  const Eigen::VectorXd start = first_plan.visits.front().branch.q;
  const VisitPlan plan = planFrom(cell, {first_plan.visits[1].tube, first_plan.visits[2].tube}, start);
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned) << plan.reason;
  EXPECT_EQ(plan.departed, departed);
  const PathSegment& down = plan.segments.front();
  EXPECT_EQ(down.kind, SegmentKind::kRetreat);
  EXPECT_EQ(down.visit, -1);
  EXPECT_EQ(down.waypoints.front(), start);
  EXPECT_GE(down.margin, 0);
  for (const auto& q : down.waypoints)
    EXPECT_LT((deflectedTip(cell, q) - holeOf(cell, departed)).head<2>().norm(), 1e-8);
  const PlanCheck check = checkPlan(cell, testing::statedPlan(cell, plan));
  EXPECT_EQ(check.status, PlanCheckStatus::kProved) << (check.findings.empty() ? "" : check.findings.front());
}

TEST(Departure, IsRefutedUnlessItGoesStraightDownFromAHole) {
  const Workcell cell = mockup();
  const TubeBranch branch = branchAt(cell, tubesOf(cell, "R20C40").front());
  const VisitPlan plan = planFrom(cell, tubesOf(cell, "R20C44"), branch.q);
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned);
  StatedPlan stated = testing::statedPlan(cell, plan);
  for (auto& row : stated.path)
    if (row.segment == 0 && row.q != branch.q) row.q[0] += 0.001;
  EXPECT_EQ(checkPlan(cell, stated).status, PlanCheckStatus::kRefuted);
}

TEST(Departure, NoPlanBeginsInContactAwayFromAHole) {
  const Workcell cell = mockup();
  const auto between = tubesOf(cell, "R20C40");
  const Eigen::Vector3d face_W = holeOf(cell, between.front()) + Eigen::Vector3d(cell.sheet.pitch / 2, 0, 0);
  EXPECT_EQ(holeAround(cell.sheet, face_W), -1);
  EXPECT_EQ(holeAround(cell.sheet, holeOf(cell, between.front())), between.front());
  const TubeBranch branch = compensateFrom(cell, face_W, branchAt(cell, between.front()).q);
  ASSERT_EQ(branch.status, deflection::BranchStatus::kConverged);
  const VisitPlan plan = planFrom(cell, tubesOf(cell, "R20C44"), branch.q);
  EXPECT_EQ(plan.status, VisitPlanStatus::kNoOrder);
  EXPECT_NE(plan.reason.find("the start posture: "), std::string::npos);
}

TEST(Departure, IsNoneWhereTheArmMayTravelAtOnce) {
  const Workcell cell = mockup();
  const TubeBranch branch = branchAt(cell, tubesOf(cell, "R20C40").front());
  const VisitPlan plan = planFrom(cell, tubesOf(cell, "R20C44"), branch.approach.front());
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned);
  EXPECT_EQ(plan.departed, -1);
  EXPECT_EQ(plan.segments.front().kind, SegmentKind::kTravel);
}

}  // namespace
}  // namespace tubeplan::planner
