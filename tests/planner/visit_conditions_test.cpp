#include "planner/visit_conditions.hpp"

#include <gtest/gtest.h>

#include "planner/trajectory.hpp"
#include "tests/planner/verification/stated_plan.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using testing::mockup;
using testing::statedPlan;

/// A plan for seven tubes, from a park posture and back to it. It visits two zones before the other tubes, and dwells
/// at every hole.
class Conditioned : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    cell_ = std::make_unique<Workcell>(mockup());
    tubes_ = testing::tubesOf(*cell_, "R3C10,R10C95,R20C40,R30C70,R12C50,R12C51,R45C50");
    options_.conditions.start = park();
    options_.conditions.end = park();
    options_.conditions.zones = {testing::tubesOf(*cell_, "R45C50"), testing::tubesOf(*cell_, "R3C10,R10C95")};
    options_.conditions.dwell = 3;
    options_.conditions.dwell_at = {{tubes_.front(), 7.5}};
    plan_ = std::make_unique<VisitPlan>(planVisits(*cell_, tubes_, options_));
  }
  static void TearDownTestSuite() {
    plan_.reset();
    cell_.reset();
  }
  /// Returns the park posture: the standoff below a tube that is not on the list.
  static Eigen::VectorXd park() {
    const ArmClearance clearance(*cell_);
    return reachTube(clearance, testing::tubesOf(*cell_, "R25C57").front()).branches.front().approach.front();
  }
  static StatedPlan stated() {
    StatedPlan plan = statedPlan(*cell_, *plan_);
    plan.start = options_.conditions.start;
    plan.end = options_.conditions.end;
    std::vector<int> order;
    for (const auto& visit : plan_->visits) order.push_back(visit.tube);
    const auto zones = zonesOf(order, options_.conditions);
    for (std::size_t k = 0; k < zones.size(); ++k) plan.tubes[k].zone = zones[k];
    return plan;
  }

  static inline std::unique_ptr<Workcell> cell_;
  static inline std::vector<int> tubes_;
  static inline VisitPlanOptions options_;
  static inline std::unique_ptr<VisitPlan> plan_;
};

TEST_F(Conditioned, SetsOutFromParkGoesByZonesAndComesBack) {
  ASSERT_EQ(plan_->status, VisitPlanStatus::kPlanned) << plan_->reason;
  ASSERT_EQ(plan_->visits.size(), 7u);
  EXPECT_EQ(plan_->visits[0].tube, testing::tubesOf(*cell_, "R45C50").front());
  const auto second = testing::tubesOf(*cell_, "R3C10,R10C95");
  for (const std::size_t k : {1u, 2u}) EXPECT_NE(std::ranges::find(second, plan_->visits[k].tube), second.end());
  ASSERT_EQ(plan_->segments.size(), 3 * 7 + 1u);
  EXPECT_EQ(plan_->segments.front().kind, SegmentKind::kTravel);
  EXPECT_EQ(plan_->segments.front().waypoints.front(), *options_.conditions.start);
  EXPECT_EQ(plan_->segments.back().kind, SegmentKind::kTravel);
  EXPECT_EQ(plan_->segments.back().waypoints.back(), *options_.conditions.end);
  EXPECT_EQ(plan_->segments.back().visit, 6);
  for (const auto& segment : plan_->segments) EXPECT_GE(segment.margin, 0);
  EXPECT_LE(plan_->lower_bound, plan_->travel_time);
  EXPECT_GT(plan_->row_by_row_time, plan_->lower_bound);
}

TEST_F(Conditioned, StaysAtEveryHoleAsLongAsAsked) {
  double moving = 0;
  for (const auto& segment : plan_->segments) moving += durationOf(segment, jointSpeedsOf(cell_->arm));
  EXPECT_NEAR(plan_->total_time, moving + 6 * 3 + 7.5, 1e-9);
  const auto rows = samplePath(*plan_, jointSpeedsOf(cell_->arm));
  EXPECT_NEAR(rows.back().time, plan_->total_time, 1e-9);
  const auto points = trajectoryOf(*plan_, jointSpeedsOf(cell_->arm));
  EXPECT_NEAR(points.back().time, plan_->total_time, 1e-6);
  int dwells = 0;
  for (std::size_t k = 1; k < points.size(); ++k)
    dwells += points[k].position == points[k - 1].position && points[k].time - points[k - 1].time > 2.999;
  EXPECT_EQ(dwells, 7);
}

TEST_F(Conditioned, IsProvedAgainAndItsConditionsAreHeldAgainstIt) {
  const StatedPlan plan = stated();
  const PlanCheck check = checkPlan(*cell_, plan);
  EXPECT_EQ(check.status, PlanCheckStatus::kProved) << check.findings.front();
  const auto refuted = [&](auto alter) {
    StatedPlan altered = plan;
    alter(altered);
    return checkPlan(*cell_, altered).status == PlanCheckStatus::kRefuted;
  };
  EXPECT_TRUE(refuted([](StatedPlan& p) { p.start.reset(); }));
  EXPECT_TRUE(refuted([](StatedPlan& p) { p.end.reset(); }));
  EXPECT_TRUE(refuted([](StatedPlan& p) { (*p.start)[1] += 1e-6; }));
  EXPECT_TRUE(refuted([](StatedPlan& p) { (*p.end)[0] -= 1e-6; }));
  EXPECT_TRUE(refuted([](StatedPlan& p) { p.tubes[3].dwell += 0.01; }));
  EXPECT_TRUE(refuted([](StatedPlan& p) { std::swap(p.tubes[0].zone, p.tubes[6].zone); }));
}

TEST_F(Conditioned, GoesOnToTheSamePlanFromAnyMemory) {
  PlanCache cache;
  const VisitPlan first = planVisits(*cell_, tubes_, options_, {}, cache);
  const VisitPlan again = planVisits(*cell_, tubes_, options_, {}, cache);
  EXPECT_EQ(again.total_time, first.total_time);
  EXPECT_EQ(again.kept.travels, 8);
}

TEST(VisitConditions, AStartThatIsBlockedOrPastALimitIsNamed) {
  const Workcell cell = mockup();
  const auto tubes = testing::tubesOf(cell, "R20C40");
  VisitPlanOptions options;
  options.conditions.start = Eigen::VectorXd::Constant(4, 10.);
  VisitPlan plan = planVisits(cell, tubes, options);
  EXPECT_EQ(plan.status, VisitPlanStatus::kNoOrder);
  EXPECT_NE(plan.reason.find("the start posture: theta1 is past its limit"), std::string::npos) << plan.reason;
  const ArmClearance clearance(cell);
  const TubeReach reach = reachTube(clearance, tubes.front());
  options.conditions.start.reset();
  options.conditions.end = reach.branches.front().q;  // the tip is at the hole, where it may be only during an approach
  plan = planVisits(cell, tubes, options);
  EXPECT_EQ(plan.status, VisitPlanStatus::kNoOrder);
  EXPECT_NE(plan.reason.find("the end posture: tool-tip"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace tubeplan::planner
