// Plans for arms other than turret arms: the tip reaches the hole for any tilt of the base, and unreachable tubes are
// reported with the right reason.
#include <gtest/gtest.h>

#include "tests/planner/verification/stated_plan.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using testing::holeOf;
using testing::mockup;

Workcell leaning(Workcell cell, double degrees) {
  cell.X_WB.rotate(Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d(1, 0.6, 0).normalized()));
  return cell;
}

struct Cell {
  const char* file;
  int reachable;  ///< smallest number of tubes, out of eight, that must be reachable
};

class OtherArms : public ::testing::TestWithParam<Cell> {};
INSTANTIATE_TEST_SUITE_P(Shipped, OtherArms,
                         ::testing::Values(Cell{"tsm-cobra.yaml", 4}, Cell{"column.yaml", 4}, Cell{"puma.yaml", 5},
                                           Cell{"iiwa.yaml", 5}),
                         [](const auto& cell) {
                           std::string name = cell.param.file;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

TEST_P(OtherArms, ABaseThatLeansALittleChangesNoTubes) {
  const Workcell cell = mockup(GetParam().file);
  const std::vector<int> tubes = testing::tubesOf(cell, "spread:8");
  std::vector<ReachStatus> straight;
  for (const double lean : {0., 0.001, 0.5}) {
    const Workcell leans = leaning(cell, lean);
    const ArmClearance clearance(leans);
    std::vector<ReachStatus> found;
    for (const int tube : tubes) {
      const TubeReach reach = reachTube(clearance, tube);
      found.push_back(reach.status);
      for (const auto& branch : reach.branches) {
        EXPECT_LE((testing::deflectedTip(leans, branch.q) - holeOf(leans, tube)).norm(),
                  1e-9 * deflection::reachOf(leans.arm));
        EXPECT_LE(branch.tilt, tubesheets::toleratedTilt(leans.tool));
      }
    }
    if (lean == 0) straight = found;
    if (lean < 0.1) {
      EXPECT_EQ(found, straight) << lean << " deg";
    }
    EXPECT_GE(std::ranges::count(found, ReachStatus::kReachable), GetParam().reachable) << lean << " deg";
  }
}

TEST(OtherArmsPlan, ThePlanOfALeaningColumnIsProvedAgain) {
  const Workcell cell = leaning(mockup("column.yaml"), 0.5);
  const VisitPlan plan = planVisits(cell, testing::tubesOf(cell, "spread:10"));
  ASSERT_EQ(plan.status, VisitPlanStatus::kPlanned) << plan.reason;
  const PlanCheck check = checkPlan(cell, testing::statedPlan(cell, plan));
  EXPECT_EQ(check.status, PlanCheckStatus::kProved) << (check.findings.empty() ? "" : check.findings.front());
}

TEST(OtherArmsPlan, ATubeThatOnlyALeaningToolReachesIsRefusedForItsTilt) {
  const Workcell cell = leaning(mockup("column.yaml"), 12);
  const ArmClearance clearance(cell);
  int tilted = 0;
  for (const int tube : testing::tubesOf(cell, "spread:8")) {
    const TubeReach reach = reachTube(clearance, tube);
    EXPECT_EQ(reach.status, ReachStatus::kUnreachable);
    tilted += reach.reason.find("the tool leans by") != std::string::npos;
  }
  EXPECT_GE(tilted, 2);
}

TEST(ToleratedTilt, IsThatAtWhichTheFirstStepStillEnters) {
  const tubesheets::SteppedTool tool = mockup().tool;
  const double tilt = tubesheets::toleratedTilt(tool);
  const auto steps = [&](double angle) {
    return tubesheets::stepsInserted(tool, Eigen::Vector2d::Zero(), Eigen::Vector2d(std::tan(angle), 0));
  };
  EXPECT_GE(steps(tilt * (1 - 1e-9)), 1);
  EXPECT_EQ(steps(tilt * (1 + 1e-9)), 0);
  EXPECT_EQ(tubesheets::toleratedTilt({tool.steps, {}}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tubeplan::planner
