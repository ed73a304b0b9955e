// Choice of the holes to touch: the best three, their predicted accuracy, and further touches.
#include "calibration/design/touch_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

const std::vector<std::pair<double, double>> kHolesToTouch{{-40, 10}, {38, 12}, {10, 45},  {-2, 12},
                                                           {3, 14},   {0, 10},  {-25, 30}, {28, 32}};

std::vector<Eigen::VectorXd> workOf(const TouchedCell& cell) {
  std::vector<Eigen::VectorXd> work;
  for (const auto& plan : cell.plans) work.push_back(plan.q_start);
  return work;
}

TEST(TouchChoice, TheBestTripleBeatsEveryOther) {
  const auto cell = touchedCell(kHolesToTouch);
  const auto best = chooseTouches(cell.arm, cell.X_WB_nominal, cell.plans, workOf(cell));
  ASSERT_EQ(best.status, TouchChoiceStatus::kDone);
  const int n = static_cast<int>(cell.plans.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const std::vector<TouchPlan> triple{cell.plans[static_cast<std::size_t>(i)],
                                            cell.plans[static_cast<std::size_t>(j)],
                                            cell.plans[static_cast<std::size_t>(k)]};
        EXPECT_GE(chooseTouches(cell.arm, cell.X_WB_nominal, triple, workOf(cell)).mean_sigma,
                  best.mean_sigma * (1 - 1e-12));
      }
}

TEST(TouchChoice, PredictsTheSpreadOfManyCalibrations) {
  auto cell = touchedCell(kHolesToTouch);
  const auto work = workOf(cell);
  const auto best = chooseTouches(cell.arm, cell.X_WB_nominal, cell.plans, work);
  std::vector<TouchPlan> chosen;
  for (int index : best.chosen) chosen.push_back(cell.plans[static_cast<std::size_t>(index)]);
  auto touched = cell;
  touched.plans = chosen;
  double sum = 0;
  BaseCalibrationOptions exact;
  exact.arm = ArmUncertainty::none();
  constexpr int kRuns = 200;
  for (int run = 0; run < kRuns; ++run) {
    const auto found = calibrateBase(cell.arm, touchesOf(touched, 0.005, 50 + static_cast<std::uint64_t>(run)),
                                     cell.X_WB_nominal, exact);
    for (const auto& q : work) {
      const Eigen::Vector3d off =
          predictTip(cell.arm, found.X_WB, q, 0).value - predictTip(cell.arm, cell.X_WB_true, q, 0).value;
      sum += off.squaredNorm() / (3. * kRuns * static_cast<double>(work.size()));
    }
  }
  EXPECT_NEAR(std::sqrt(sum), best.mean_sigma, 0.12 * best.mean_sigma);
}

TEST(TouchChoice, MoreTouchesAreBetterAndTooFewCandidatesAreTold) {
  const auto cell = touchedCell(kHolesToTouch);
  const auto three = chooseTouches(cell.arm, cell.X_WB_nominal, cell.plans, workOf(cell));
  const auto five = chooseTouches(cell.arm, cell.X_WB_nominal, cell.plans, workOf(cell), {5, 1.27e-4});
  EXPECT_EQ(five.chosen.size(), 5u);
  EXPECT_LT(five.mean_sigma, three.mean_sigma);
  EXPECT_EQ(chooseTouches(cell.arm, cell.X_WB_nominal, cell.plans, workOf(cell), {20, 1.27e-4}).status,
            TouchChoiceStatus::kTooFewCandidates);
}

TEST(TouchChoice, HolesThatDoNotDetermineTheBaseAreToldSo) {
  const auto cell = touchedCell(kHolesToTouch);
  const std::vector<TouchPlan> one_hole(4, cell.plans.front());
  const auto choice = chooseTouches(cell.arm, cell.X_WB_nominal, one_hole, workOf(cell));
  EXPECT_EQ(choice.status, TouchChoiceStatus::kNotDetermined) << choice.mean_sigma;
  EXPECT_TRUE(choice.chosen.empty());
  EXPECT_FALSE(choice.reason.empty());
}

}  // namespace
}  // namespace tubeplan::calibration
