#include "calibration/design/touch_reserve.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

/// Positions of holes [in]; the first two, at the ends of the mock-up's first row, are almost out of reach.
const std::vector<std::pair<double, double>> kHolesAtTheEdge{{-60.03, 2.28}, {60.03, 2.28}, {-40, 10}, {38, 12},
                                                             {10, 45},       {-2, 12},      {-25, 30}, {28, 32}};

std::vector<std::string> namesOf(const std::vector<TouchPlan>& plans) {
  std::vector<std::string> names;
  for (const auto& plan : plans) names.push_back(plan.hole);
  return names;
}

TEST(TouchReserve, WithoutDoubtEveryHoleInReachIsKept) {
  const auto cell = touchedCell(kHolesAtTheEdge);
  EXPECT_EQ(namesOf(keepTouchable(cell.arm, cell.X_WB_nominal, cell.plans, {0, 0})), namesOf(cell.plans));
}

TEST(TouchReserve, NoHoleIsInReachFromEverywhere) {
  const auto cell = touchedCell(kHolesAtTheEdge);
  EXPECT_TRUE(keepTouchable(cell.arm, cell.X_WB_nominal, cell.plans, {3, 0}).empty());
}

TEST(TouchReserve, KeptHolesAreTouchedFromBasesOfAThirdOfTheDoubt) {
  const auto cell = touchedCell(kHolesAtTheEdge);
  const BaseUncertainty uncertainty;
  const auto kept = keepTouchable(cell.arm, cell.X_WB_nominal, cell.plans, uncertainty);
  ASSERT_GE(kept.size(), 3U);
  EXPECT_LT(kept.size(), cell.plans.size());
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
  TouchSimulationOptions exact;
  exact.sigma = 0;
  constexpr int kRuns = 400;
  int touched = 0;
  for (int run = 0; run < kRuns; ++run) {
    Eigen::Isometry3d X = cell.X_WB_nominal;
    X.translation() += uncertainty.shift / 3 * draw();
    const Eigen::Vector3d turn = uncertainty.turn / 3 * draw();
    X.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * X.linear();
    touched += simulateTouches(cell.arm, X, kept, exact).status == TouchSimulationStatus::kDone;
  }
  EXPECT_GE(touched, 0.99 * kRuns);
}

}  // namespace
}  // namespace tubeplan::calibration
