// The predicted covariance of a calibrated arm's tip error must agree with closed forms and with simulated
// calibrations.
#include "calibration/forecast/tip_error.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns postures at holes other than the touched ones.
std::vector<Eigen::VectorXd> otherPostures() {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& plan : touchedCell({{-20, 20}, {0, 30}, {25, 15}, {-30, 35}}).plans)
    postures.push_back(plan.q_start);
  return postures;
}

Eigen::Matrix2d covarianceOf(const std::vector<TipErrorCase>& cases) {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& tip : cases) covariance += tip.weight * tip.covariance;
  return covariance;
}

TEST(TipError, OfAnExactArmIsThatOfBaseAndMeasurements) {
  const auto cell = touchedCell();
  BaseCalibrationOptions exact;
  exact.arm = ArmUncertainty::none();
  const auto base = calibrateBase(cell.arm, touchesOf(cell, 0.005, 3), cell.X_WB_nominal, exact);
  const auto postures = otherPostures();
  const auto found = findTipError({base.arm, base.X_WB, 0, base.uncertainty, {}, postures});
  for (std::size_t k = 0; k < postures.size(); ++k) {
    ASSERT_EQ(found[k].size(), 1u);
    const auto tip = predictTip(cell.arm, base.X_WB, postures[k], 0);
    const Eigen::Matrix2d expected = tipCovariance(cell.arm, tip, base.covariance).topLeftCorner<2, 2>();
    EXPECT_TRUE(found[k][0].covariance.isApprox(expected, 1e-6)) << found[k][0].covariance << "\n" << expected;
  }
}

TEST(TipError, IsAsStatedOverArmsWhoseNumbersAreOff) {
  const auto cell = touchedCell();
  const auto postures = otherPostures();
  const ArmUncertainty uncertainty;
  constexpr int kRuns = 300;
  std::vector<double> square(postures.size(), 0);  // mean squared error relative to its covariance; expected: 2
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    auto truth = cell;
    truth.arm = drawnArm(cell.arm, uncertainty, seed);
    for (auto& row : truth.arm.rows) row.joint.encoder_sigma = 0;
    auto model = cell.arm;
    for (auto& row : model.rows) row.joint.encoder_sigma = 0;
    const auto base = calibrateBase(model, touchesOf(truth, 0.005, seed), cell.X_WB_nominal);
    const auto found = findTipError({base.arm, base.X_WB, 0, base.uncertainty, {}, postures});
    for (std::size_t k = 0; k < postures.size(); ++k) {
      const Eigen::Vector2d off = (predictTip(base.arm, base.X_WB, postures[k], 0).value -
                                   predictTip(truth.arm, cell.X_WB_true, postures[k], 0).value)
                                      .head<2>();
      square[k] += off.dot(found[k][0].covariance.ldlt().solve(off)) / kRuns;
    }
  }
  for (const double mean : square) EXPECT_NEAR(mean, 2, 3 * 2 / std::sqrt(static_cast<double>(kRuns)));
}

TEST(TipError, WhatBaseAndNumbersTakeUpOfEachOtherMovesNoTipThatWasTouched) {
  const auto cell = touchedCell();
  const auto touches = touchesOf(cell, 0.005, 3);
  const auto base = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  const JointUncertainty base_alone{{}, base.covariance};
  std::vector<Eigen::VectorXd> touched;
  for (const auto& touch : touches) touched.push_back(touch.q);
  const auto together = findTipError({base.arm, base.X_WB, 0, base.uncertainty, {}, touched});
  const auto separate = findTipError({base.arm, base.X_WB, 0, base_alone, {}, touched});
  for (std::size_t k = 0; k < touched.size(); ++k) {
    EXPECT_LT(std::sqrt(covarianceOf(together[k]).trace() / 2), 0.01 * kInch) << "about the touch's own noise";
    EXPECT_GT(std::sqrt(covarianceOf(separate[k]).trace() / 2), 0.01 * kInch);
  }
}

TEST(TipError, OfACalibrationThatIsReadAgainIsTheSame) {
  const auto cell = touchedCell();
  const auto touches = touchesOf(cell, 0.005, 3);
  const auto base = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  const auto again =
      uncertaintyByTouches(base.arm, base.X_WB, uncertainNumbers(base.arm, ArmUncertainty{}), touches, 0);
  ASSERT_TRUE(again.has_value());
  const auto first = findTipError({base.arm, base.X_WB, 0, base.uncertainty, {}, otherPostures()});
  const auto second = findTipError({base.arm, base.X_WB, 0, *again, {}, otherPostures()});
  for (std::size_t k = 0; k < first.size(); ++k)
    EXPECT_TRUE(first[k][0].covariance.isApprox(second[k][0].covariance, 0.05));
}

TEST(TipError, WithFewDegreesOfFreedomHasWiderTails) {
  const auto cell = touchedCell();
  const double size = 0.02 * kInch;
  const JointUncertainty exact{{}, Eigen::MatrixXd::Zero(6, 6)};
  const auto variance = [&](double sigma, int freedom) {
    const auto found =
        findTipError({cell.arm, cell.X_WB_true, 0, exact, StatedModelError{sigma, freedom}, otherPostures()});
    const double weight = std::accumulate(found[0].begin(), found[0].end(), 0.,
                                          [](double sum, const auto& tip) { return sum + tip.weight; });
    EXPECT_NEAR(weight, 1, 1e-12);
    return covarianceOf(found[0]).trace() / 2 / (size * size);
  };
  const double encoders = variance(0, 0);
  EXPECT_NEAR(variance(size, 0) - encoders, 1, 1e-9);
  // Student's t has the variance n / (n - 2); eight discrete cases represent its tails only in part.
  EXPECT_NEAR(variance(size, 10) - encoders, 10 / 8., 0.05);
  EXPECT_NEAR(variance(size, 1000) - encoders, 1000 / 998., 0.01);
  EXPECT_GT(variance(size, 3), 1.5);
}

}  // namespace
}  // namespace tubeplan::calibration
