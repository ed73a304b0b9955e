// How far the tip may be off where a calibrated arm is sent to, by touches and by what a cell states.
#include "calibration/forecast/tip_error.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "calibration/forecast/hidden_effects.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

const Eigen::Matrix<double, 6, 6> kNoCovariance = Eigen::Matrix<double, 6, 6>::Zero();

/// Postures under other holes than those touched.
std::vector<Eigen::VectorXd> otherPostures() {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& plan : touchedCell({{-20, 20}, {0, 30}, {25, 15}, {-30, 35}}).plans)
    postures.push_back(plan.q_start);
  return postures;
}

double weightOf(const std::vector<TipErrorCase>& cases) {
  return std::accumulate(cases.begin(), cases.end(), 0., [](double sum, const auto& tip) { return sum + tip.weight; });
}

Eigen::Matrix2d covarianceOf(const std::vector<TipErrorCase>& cases) {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& tip : cases) covariance += tip.weight * (tip.covariance + tip.mean * tip.mean.transpose());
  return covariance;
}

TEST(TipError, OfAModelWithoutErrorIsThatOfBaseAndReadings) {
  const auto cell = touchedCell();
  const auto touches = touchesOf(cell, 0.005, 3);
  const auto base = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  const auto postures = otherPostures();
  const TipErrorQuestion asked{cell.arm, base.X_WB, 0, touches, kNoCovariance, StatedModelError{0, 0}, postures};
  const TipError found = findTipError(asked);
  EXPECT_EQ(found.source, ModelErrorSource::kStated);
  for (std::size_t k = 0; k < postures.size(); ++k) {
    ASSERT_EQ(found.at[k].size(), 1u);
    const auto tip = predictTip(cell.arm, base.X_WB, postures[k], 0);
    const Eigen::Matrix2d expected = tipCovariance(cell.arm, tip, base.covariance).topLeftCorner<2, 2>();
    EXPECT_TRUE(found.at[k][0].covariance.isApprox(expected, 1e-6)) << found.at[k][0].covariance << "\n" << expected;
    EXPECT_LE(found.at[k][0].mean.norm(), 1e-9 * kInch);
  }
}

TEST(TipError, AStatedErrorAddsToBaseAndHole) {
  const auto cell = touchedCell();
  const auto touches = touchesOf(cell, 0.005, 3);
  const auto base = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  const double sigma = 0.02 * kInch;
  const TipErrorQuestion none{cell.arm, base.X_WB, 0, touches, kNoCovariance, StatedModelError{0, 0}, otherPostures()};
  const TipErrorQuestion some{cell.arm,       base.X_WB, 0, touches, kNoCovariance, StatedModelError{sigma, 0},
                              otherPostures()};
  const auto without = findTipError(none), with = findTipError(some);
  for (std::size_t k = 0; k < with.at.size(); ++k) {
    const Eigen::Matrix2d more = covarianceOf(with.at[k]) - covarianceOf(without.at[k]);
    EXPECT_GT(more.eigenvalues().real().minCoeff(), sigma * sigma) << "at the hole alone, and more by the base";
    EXPECT_LT(more.eigenvalues().real().maxCoeff(), 4 * sigma * sigma);
  }
}

TEST(TipError, WithFewDegreesOfFreedomHasWiderTails) {
  const auto cell = touchedCell();
  const double size = 0.02 * kInch;
  const auto variance = [&](double sigma, int freedom) {
    const TipErrorQuestion asked{cell.arm,       cell.X_WB_true, 0, {}, kNoCovariance, StatedModelError{sigma, freedom},
                                 otherPostures()};
    const TipError found = findTipError(asked);
    EXPECT_NEAR(weightOf(found.at[0]), 1, 1e-12);
    return covarianceOf(found.at[0]).trace() / 2 / (size * size);
  };
  const double encoders = variance(0, 0);
  EXPECT_NEAR(variance(size, 0) - encoders, 1, 1e-9);
  // Student's t has the variance n / (n - 2).
  EXPECT_NEAR(variance(size, 10) - encoders, 10 / 8., 0.01);
  EXPECT_NEAR(variance(size, 1000) - encoders, 1000 / 998., 0.01);
}

TEST(TipError, GrowsWithTheMisfitOfTheTouches) {
  const auto cell = touchedCell({{-40, 10}, {38, 12}, {10, 45}, {-5, 20}});
  auto touches = touchesOf(cell, 0.005, 3);
  const auto errorAt = [&] {
    const auto base = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
    const TipErrorQuestion asked{cell.arm, base.X_WB, 0, touches, kNoCovariance, std::nullopt, otherPostures()};
    const TipError found = findTipError(asked);
    EXPECT_EQ(found.source, ModelErrorSource::kTouches);
    for (const auto& cases : found.at) EXPECT_NEAR(weightOf(cases), 1, 1e-12);
    EXPECT_LE(found.lower, found.model_error);
    EXPECT_LE(found.model_error, found.upper);
    return found.model_error;
  };
  const double before = errorAt();
  EXPECT_LT(before, 0.01 * kInch);
  touches[3].p_W->x() += 0.1 * kInch;
  EXPECT_GT(errorAt(), 4 * before);
}

TEST(HiddenEffects, MoveTheTipInProportionAndLeaveOutWhatATouchDoesNotRecord) {
  const auto cell = touchedCell();
  HiddenEffects small(cell.arm, 0.01), large(cell.arm, 0.02);
  ASSERT_EQ(small.kinds().size(), large.kinds().size());
  EXPECT_GT(small.kinds().size(), 50u);
  const auto few = small.at(cell.X_WB_true, cell.plans[0].q_start, 0);
  const auto many = large.at(cell.X_WB_true, cell.plans[0].q_start, 0);
  int alike = 0;
  for (Eigen::Index k = 0; k < few.cols(); ++k) alike += (few.col(k) - many.col(k)).norm() <= 0.1 * few.col(k).norm();
  EXPECT_GT(alike, 0.9 * static_cast<double>(few.cols()));
  const auto& table = deflection::effectKinds();
  for (const int kind : small.kinds()) {
    const bool is_effect = kind < static_cast<int>(table.size());  // the last stands for stiffnesses
    EXPECT_FALSE(is_effect && table[static_cast<std::size_t>(kind)].needs.time);
  }
}

}  // namespace
}  // namespace tubeplan::calibration
