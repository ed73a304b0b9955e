#include "planner/visit_plan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <set>

#include "planner/timing/flowing_timing.hpp"
#include "planner/travel_network.hpp"
#include "planner/verification/plan_checks.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/plan_bytes.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::bytesOf;
using testing::holeOf;
using testing::mockup;
using testing::obstacleInInches;
using testing::withObstacle;

/// Returns the scene for travelling, derived independently: the tool tip, too, must keep clear of the sheet.
Scene travellingScene(Scene scene) {
  for (auto& obstacle : scene.obstacles) std::erase(obstacle.allow, "tool-tip");
  return scene;
}

/// The mock-up's plan for a few tubes, computed once for all tests.
class MockupPlan : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    cell_ = std::make_unique<Workcell>(mockup());
    tubes_ = testing::tubesOf(*cell_, "spread:8");
    if (std::ranges::find(tubes_, kBehind()) == tubes_.end()) tubes_.push_back(kBehind());
    plan_ = std::make_unique<VisitPlan>(planVisits(*cell_, tubes_));
  }
  static void TearDownTestSuite() {
    plan_.reset();
    cell_.reset();
  }
  static int kBehind() { return testing::tubesOf(*cell_, "R39C58").front(); }

  static inline std::unique_ptr<Workcell> cell_;
  static inline std::vector<int> tubes_;
  static inline std::unique_ptr<VisitPlan> plan_;
};

TEST_F(MockupPlan, VisitsEveryTubeOnceOrNamesItWithItsReason) {
  ASSERT_EQ(plan_->status, VisitPlanStatus::kPlanned) << plan_->reason;
  std::multiset<int> seen;
  for (const auto& visit : plan_->visits) seen.insert(visit.tube);
  for (const auto& missed : plan_->unreachable) {
    seen.insert(missed.tube);
    EXPECT_FALSE(missed.reason.empty());
  }
  EXPECT_EQ(seen, std::multiset<int>(tubes_.begin(), tubes_.end()));
  ASSERT_EQ(plan_->unreachable.size(), 1u);
  EXPECT_EQ(plan_->unreachable[0].tube, kBehind());
  EXPECT_NE(plan_->unreachable[0].reason.find("theta1"), std::string::npos);
}

TEST_F(MockupPlan, PutsEveryDeflectedTipOnItsHolesCentreWithinLimits) {
  for (const auto& visit : plan_->visits) {
    EXPECT_LT((testing::deflectedTip(*cell_, visit.branch.q) - holeOf(*cell_, visit.tube)).norm(), 1e-6 * kInch);
    EXPECT_TRUE(testing::withinLimits(cell_->arm, visit.branch.q));
  }
}

TEST_F(MockupPlan, IsOneUnbrokenPathUpDownAndOn) {
  static constexpr SegmentKind kCycle[] = {SegmentKind::kApproach, SegmentKind::kRetreat, SegmentKind::kTravel};
  ASSERT_EQ(plan_->segments.size(), 3 * plan_->visits.size() - 1);
  for (std::size_t k = 0; k < plan_->segments.size(); ++k) {
    const auto& segment = plan_->segments[k];
    EXPECT_EQ(segment.kind, kCycle[k % 3]);
    EXPECT_EQ(segment.visit, static_cast<int>((k + 1) / 3));
    if (k > 0) {
      EXPECT_EQ(segment.waypoints.front(), plan_->segments[k - 1].waypoints.back());
    }
    if (segment.kind == SegmentKind::kApproach) {
      EXPECT_EQ(segment.waypoints.back(), plan_->visits[k / 3].branch.q);
    }
    for (const auto& q : segment.waypoints) EXPECT_TRUE(testing::withinLimits(cell_->arm, q));
  }
}

TEST_F(MockupPlan, TravelsAreAsClearAsTheyWereProved) {
  const CollisionWorld world(travellingScene(cell_->scene));
  std::vector<const PathSegment*> travels;
  for (const auto& segment : plan_->segments)
    if (segment.kind == SegmentKind::kTravel) travels.push_back(&segment);
  std::ranges::stable_sort(travels, {}, [](const PathSegment* segment) { return segment->margin; });
  ASSERT_GE(travels.size(), 3u);
  // The three travels with the smallest margins are sampled at 10,000 postures each.
  for (std::size_t t = 0; t < 3; ++t) {
    const auto waypoints = cornersOf(*travels[t], jointSpeedsOf(cell_->arm));
    const int share = static_cast<int>(10000 / (waypoints.size() - 1));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < waypoints.size(); ++k)
      for (int s = 0; s <= share; ++s) {
        double bow = 0;
        const auto frames =
            bodyFrames(*cell_, waypoints[k] + static_cast<double>(s) / share * (waypoints[k + 1] - waypoints[k]), &bow);
        least = std::min(least, world.closest(frames).margin - bow);
      }
    EXPECT_GE(least, travels[t]->margin - 1e-9);
    EXPECT_LE(least, travels[t]->margin + 1.1 * VisitPlanOptions().report_accuracy);
    EXPECT_GE(travels[t]->margin, 0);
  }
}

TEST_F(MockupPlan, TimesAndMarginsAddUp) {
  const JointSpeeds speeds = jointSpeedsOf(cell_->arm);
  double travel = 0, total = 0, least = std::numeric_limits<double>::infinity();
  for (const auto& segment : plan_->segments) {
    double time = segment.flows ? timeFlow(segment.waypoints, speeds).duration : 0;
    for (std::size_t k = 0; k + 1 < segment.waypoints.size() && !segment.flows; ++k)
      time += straightMoveDuration(segment.waypoints[k], segment.waypoints[k + 1], speeds);
    total += time;
    if (segment.kind == SegmentKind::kTravel) travel += time;
    least = std::min(least, segment.margin);
  }
  EXPECT_NEAR(plan_->travel_time, travel, 1e-9);
  EXPECT_NEAR(plan_->total_time, total, 1e-9);
  EXPECT_EQ(plan_->min_margin, least);
  EXPECT_GT(plan_->lower_bound, 0);
  EXPECT_LE(plan_->lower_bound, plan_->travel_time + 1e-9);
  EXPECT_NEAR(plan_->optimality_gap, plan_->travel_time / plan_->lower_bound - 1, 1e-12);
  EXPECT_GE(plan_->row_by_row_time, plan_->lower_bound);
}

TEST_F(MockupPlan, SampledPathKeepsEveryCornerAndRisesInSmallSteps) {
  const JointSpeeds speeds = jointSpeedsOf(cell_->arm);
  const auto rows = samplePath(*plan_, speeds, 0.2);
  EXPECT_EQ(rows.front().time, 0);
  EXPECT_NEAR(rows.back().time, plan_->total_time, 1e-9);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_GT(rows[k].time, rows[k - 1].time);
    EXPECT_LE(rows[k].time - rows[k - 1].time, 0.2 + 1e-9);
    EXPECT_EQ(rows[k].kind, plan_->segments[static_cast<std::size_t>(rows[k].segment)].kind);
  }
  std::size_t row = 0;
  for (const auto& segment : plan_->segments)
    for (const auto& corner : cornersOf(segment, speeds)) {
      while (row < rows.size() && rows[row].q != corner) ++row;
      ASSERT_LT(row, rows.size()) << "a corner is not among the rows";
    }
}

TEST_F(MockupPlan, SameSeedIsTheSamePlanToTheByteOnOneAndTwoThreads) {
  const std::string expected = bytesOf(*plan_);
  for (std::size_t threads : {1, 2}) {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(bytesOf(planVisits(*cell_, tubes_)), expected) << threads << " threads";
  }
}

TEST_F(MockupPlan, AnotherSeedIsAnotherSearchForAnEquallySoundPlan) {
  VisitPlanOptions options;
  options.seed = 77;
  const VisitPlan other = planVisits(*cell_, tubes_, options);
  ASSERT_EQ(other.status, VisitPlanStatus::kPlanned);
  EXPECT_EQ(other.visits.size(), plan_->visits.size());
  EXPECT_GE(other.min_margin, 0);
  EXPECT_LE(other.travel_time, 1.05 * plan_->travel_time);
}

TEST(PlanVisits, TheToolTipKeepsOffTheSheetBetweenHolesThoughItTouchesItBelowThem) {
  const Workcell cell = mockup();
  const VisitPlan plan = planVisits(cell, testing::tubesOf(cell, "R10C30,R10C33"));
  ASSERT_EQ(plan.segments.size(), 5u);
  const CollisionWorld travelling(travellingScene(cell.scene));
  const auto gapAt = [&](const VectorXd& q) {
    for (const auto& pair : travelling.allPairs(bodyFrames(cell, q, nullptr)))
      if (pair.clearance.body == "tool-tip" && pair.clearance.other == "tubesheet") return pair.clearance.distance;
    return std::nan("");
  };
  EXPECT_LT(gapAt(plan.visits[0].branch.q), cell.scene.clearance);
  const auto& travel = plan.segments[2];
  ASSERT_EQ(travel.kind, SegmentKind::kTravel);
  for (std::size_t k = 0; k + 1 < travel.waypoints.size(); ++k)
    for (int s = 0; s <= 500; ++s)
      EXPECT_GE(gapAt(travel.waypoints[k] + s / 500. * (travel.waypoints[k + 1] - travel.waypoints[k])),
                cell.scene.clearance);
}

TEST(PlanVisits, ANozzleDamMovedUnderATubeIsNamed) {
  const Workcell cell = mockup();
  const auto tubes = testing::tubesOf(cell, "R10C30,R20C80");
  ASSERT_EQ(planVisits(cell, tubes).visits.size(), 2u);
  const Vector3d hole = holeOf(cell, tubes[0]) / kInch;
  const Workcell moved = withObstacle(
      cell, obstacleInInches("nozzle-dam", "cylinder", {hole.x(), hole.y(), -12, hole.x(), hole.y(), -4, 6}));
  const VisitPlan plan = planVisits(moved, tubes);
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned);
  ASSERT_EQ(plan.visits.size(), 1u);
  EXPECT_EQ(plan.visits[0].tube, tubes[1]);
  ASSERT_EQ(plan.unreachable.size(), 1u);
  EXPECT_EQ(plan.unreachable[0].tube, tubes[0]);
  EXPECT_EQ(plan.unreachable[0].blocking.other, "nozzle-dam");
  EXPECT_NE(plan.unreachable[0].reason.find("comes too near nozzle-dam"), std::string::npos)
      << plan.unreachable[0].reason;
}

TEST(PlanVisits, AWallAroundTheBaseLeavesNothingToPlan) {
  // The turret is at (0, 28) in. The arm can fold within the walls, 21 in away, but cannot get out.
  Workcell cell = mockup();
  for (const auto& [name, x, y, wide, deep] :
       {std::tuple{"wall-west", -21., 28., 1., 43.}, std::tuple{"wall-east", 21., 28., 1., 43.},
        std::tuple{"wall-south", 0., 7., 43., 1.}, std::tuple{"wall-north", 0., 49., 43., 1.}})
    cell = withObstacle(cell, obstacleInInches(name, "box", {x, y, -30.3, wide, deep, 60}));
  const auto tubes = testing::tubesOf(cell, "R3C10,R10C95,R20C20,R40C40");
  ASSERT_EQ(planVisits(mockup(), tubes).visits.size(), tubes.size());
  const VisitPlan plan = planVisits(cell, tubes);
  EXPECT_EQ(plan.status, VisitPlanStatus::kNothingReachable);
  EXPECT_EQ(plan.reason, "none of the tubes can be reached");
  EXPECT_TRUE(plan.visits.empty());
  EXPECT_TRUE(plan.segments.empty());
  ASSERT_EQ(plan.unreachable.size(), tubes.size());
  for (const auto& missed : plan.unreachable) {
    EXPECT_NE(missed.reason.find("comes too near wall-"), std::string::npos) << missed.reason;
    EXPECT_EQ(missed.blocking.other.substr(0, 5), "wall-");
  }
}

TEST(PlanVisits, TubesBehindAPartitionAreLeftOutWithWhatIsInTheWay) {
  // The partition extends from the divider past the shoulder's circle and is as high as the sheet. The turret turns
  // freely, but the latch-link cannot pass. The path around the back exceeds the first joint's limit. A straight move
  // between the tubes would clear the divider.
  Obstacle wall = obstacleInInches("partition", "box", {0, 12, -31.6, 0.5, 23, 62});
  wall.allow = {"base-link"};
  const Workcell cell = withObstacle(mockup(), wall);
  VisitPlanOptions options;
  options.motion.max_iterations = 300;
  options.reprice_rounds = 3;
  const auto tubes = testing::tubesOf(cell, "R13C43,R15C40,R13C72");
  const VisitPlan plan = planVisits(cell, tubes, options);
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned);
  EXPECT_EQ(plan.visits.size() + plan.unreachable.size(), tubes.size());
  ASSERT_FALSE(plan.unreachable.empty());
  for (const auto& missed : plan.unreachable) {
    EXPECT_NE(missed.reason.find("the search did not connect it"), std::string::npos) << missed.reason;
    EXPECT_NE(missed.reason.find("partition"), std::string::npos) << missed.reason;
  }
  EXPECT_GE(plan.min_margin, 0);
}

TEST(PlanVisits, NoTubesIsNoPlan) {
  const VisitPlan plan = planVisits(mockup(), {});
  EXPECT_EQ(plan.status, VisitPlanStatus::kNothingReachable);
}

TEST(PlanVisits, StopsWhenAskedAndTellsHowFarItIs) {
  const Workcell cell = mockup();
  const auto tubes = testing::tubesOf(cell, "spread:4");
  std::set<std::string> stages;
  PlanHooks hooks;
  hooks.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    stages.insert(std::string(stage));
    EXPECT_LE(done, total);
  };
  EXPECT_EQ(planVisits(cell, tubes, {}, hooks).status, VisitPlanStatus::kPlanned);
  EXPECT_EQ(stages, (std::set<std::string>{"proof", "reach", "travel"}));
  for (const std::string last : {"reach", "travel", "proof"}) {
    std::atomic<bool> stop = false;
    hooks.progress = [&](std::string_view stage, std::size_t, std::size_t) { stop = stop || stage == last; };
    hooks.stop = [&] { return stop.load(); };
    EXPECT_EQ(planVisits(cell, tubes, {}, hooks).status, VisitPlanStatus::kStopped) << last;
  }
}

TEST(PlanVisits, TheSearchForTheOrderIsAStageAndCanBeStopped) {
  const Workcell cell = mockup();
  const auto tubes = testing::tubesOf(cell, "spread:4");
  VisitPlanOptions options;
  options.order.most_exact_work = 0;
  std::set<std::string> stages;
  PlanHooks hooks;
  hooks.progress = [&](std::string_view stage, std::size_t, std::size_t) { stages.emplace(stage); };
  EXPECT_EQ(planVisits(cell, tubes, options, hooks).status, VisitPlanStatus::kPlanned);
  EXPECT_TRUE(stages.contains("order"));
  stages.clear();
  hooks.stop = [&] { return stages.contains("order"); };
  EXPECT_EQ(planVisits(cell, tubes, options, hooks).status, VisitPlanStatus::kStopped);
}

TEST(TravelNetwork, ThereAndBackAreTheSameWay) {
  const Workcell cell = mockup();
  const VisitPlanOptions options;
  const PlanHooks hooks;
  PlanCache cache, other_cache;
  const PlanContext context{cell, options, hooks, cache}, other_context{cell, options, hooks, other_cache};
  std::vector<TubeReach> reach;
  for (int tube : testing::tubesOf(cell, "R10C20,R30C40,R10C95")) reach.push_back(reachTube(context.clearance, tube));
  TravelRoadmap roadmap(context);
  TravelNetwork network(context, reach, roadmap);
  TravelNetwork other(other_context, reach, roadmap);
  const Stop a{0, 0}, b{2, 0}, c{1, 0};
  const MotionPlan forth = network.between(a, b);
  ASSERT_EQ(forth.status, MotionPlanStatus::kFree) << forth.reason;
  EXPECT_EQ(cache.travels.size(), 1u);
  MotionPlan back = network.between(b, a);
  std::ranges::reverse(back.waypoints);
  EXPECT_EQ(forth.waypoints, back.waypoints);
  EXPECT_EQ(forth.waypoints.front(), network.standoff(a));
  EXPECT_GE(network.timeOf(forth),
            moveDuration(network.standoff(a), network.standoff(b), jointSpeedsOf(cell.arm)) - 1e-9);
  // A request in the opposite direction, after other requests, gives the same motion.
  (void)other.between(c, a);
  EXPECT_EQ(other.between(b, a).waypoints, network.between(b, a).waypoints);
  EXPECT_EQ(network.timeOf(MotionPlan{}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tubeplan::planner
