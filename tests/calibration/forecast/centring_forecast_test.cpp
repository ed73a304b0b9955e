// The forecast centring error due to the uncertainty of the fit must agree with closed forms.
#include "calibration/forecast/centring_forecast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns a fit in which only the base is uncertain, with this covariance.
Identification baseFit(const Eigen::Matrix<double, 6, 6>& covariance) {
  Identification fit;
  fit.status = IdentificationStatus::kDone;
  fit.fitted = cobra();
  fit.fitted.base_poses.front().is_known = false;
  PlacedArm placed = fit.fitted;
  for (const auto& unknown : chooseUnknowns(placed, {{}, true}).list) {
    IdentifiedNumber number;
    number.unknown = unknown;
    fit.numbers.push_back(number);
  }
  fit.covariance = covariance;
  return fit;
}

std::vector<Eigen::VectorXd> somePostures(int count) {
  MeasurementMaker maker(cobra(), 3);
  std::vector<Eigen::VectorXd> postures;
  for (int k = 0; k < count; ++k) postures.push_back(maker.drawPosture());
  return postures;
}

// A shift of the base moves all tips equally, so each figure must have the distribution of the length of a plane normal
// vector: the median sigma sqrt(2 ln 2), the quantiles sigma sqrt(-2 ln(1 - p)).
TEST(CentringForecast, aShiftOfTheBaseIsRayleighAtEveryHole) {
  constexpr double kSigma = 1e-3;
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  covariance.diagonal().head<3>().setConstant(kSigma * kSigma);
  CentringForecastOptions options;
  const auto forecast = forecastCentring(baseFit(covariance), somePostures(12), options);
  ASSERT_EQ(forecast.status, CentringForecastStatus::kDone);
  EXPECT_EQ(forecast.numbers, 6);
  for (const auto& figure : {forecast.median, forecast.p95, forecast.worst}) {
    EXPECT_NEAR(figure.value, kSigma * std::sqrt(2 * std::log(2.)), 0.02 * kSigma);
    EXPECT_NEAR(figure.lower, kSigma * std::sqrt(-2 * std::log(0.975)), 0.02 * kSigma);
    EXPECT_NEAR(figure.upper, kSigma * std::sqrt(-2 * std::log(0.025)), 0.08 * kSigma);
  }
}

// If only the height of the base is uncertain, the forecast lateral error must be zero.
TEST(CentringForecast, aLiftOfTheBaseMovesNoTipSideways) {
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  covariance(2, 2) = 1e-6;
  const auto forecast = forecastCentring(baseFit(covariance), somePostures(5));
  EXPECT_LT(forecast.worst.upper, 1e-9);
}

// A yaw of the base moves a tip in proportion to its distance from the base's axis, so the farthest tip must have the
// largest error.
TEST(CentringForecast, aYawMovesTheFurthestTipMost) {
  constexpr double kSigma = 1e-3;
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  covariance(5, 5) = kSigma * kSigma;
  const auto postures = somePostures(9);
  const auto fit = baseFit(covariance);
  std::vector<double> radii;
  for (const auto& q : postures) {
    const auto& X_WB = fit.fitted.base_poses.front().X_WB;
    radii.push_back((predictTip(fit.fitted.arm, X_WB, q, 0).value - X_WB.translation()).head<2>().norm());
  }
  CentringForecastOptions options;
  const auto forecast = forecastCentring(fit, postures, options);
  const auto furthest = std::max_element(radii.begin(), radii.end());
  EXPECT_EQ(forecast.worst_posture, furthest - radii.begin());
  // The median absolute value of a normal variable is 0.6745 sigma.
  EXPECT_NEAR(forecast.worst.value, 0.6745 * kSigma * *furthest, 0.02 * kSigma * *furthest);
}

TEST(CentringForecast, aLargerCovarianceWidensItAndAKnownBaseMayBringItsOwn) {
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Identity() * 1e-8;
  auto fit = baseFit(covariance);
  const auto postures = somePostures(7);
  const double plain = forecastCentring(fit, postures).median.value;
  fit.covariance *= 9;
  EXPECT_NEAR(forecastCentring(fit, postures).median.value, 3 * plain, 1e-12);

  Identification known;
  known.status = IdentificationStatus::kDone;
  known.fitted = cobra();
  const auto nothing = forecastCentring(known, postures);
  EXPECT_EQ(nothing.status, CentringForecastStatus::kNothingUncertain);
  EXPECT_TRUE(std::isnan(nothing.median.value));
  CentringForecastOptions options;
  options.base_covariance = covariance;
  EXPECT_NEAR(forecastCentring(known, postures, options).median.value, plain, 1e-9 * plain);
}

// If only one encoder is noisy, the error must be the lever arm of its joint times the standard deviation of the noise.
TEST(CentringForecast, theEncodersShareIsTheirNoiseThroughTheJacobian) {
  auto fit = baseFit(Eigen::Matrix<double, 6, 6>::Identity() * 1e-8);
  fit.fitted.base_poses.front().X_WB = Eigen::Isometry3d::Identity();
  const auto active = deflection::activeRows(fit.fitted.arm);
  for (const int row : active) fit.fitted.arm.rows[static_cast<std::size_t>(row)].joint.encoder_sigma = 0;
  fit.fitted.arm.rows[static_cast<std::size_t>(active[0])].joint.encoder_sigma = 1e-4;
  const auto postures = somePostures(1);
  const double step = 1e-5;
  Eigen::VectorXd q = postures[0];
  q[0] += step;
  const auto tip = [&](const Eigen::VectorXd& at) {
    return predictTip(fit.fitted.arm, fit.fitted.base_poses.front().X_WB, at, 0).value;
  };
  const double lever = (tip(q) - tip(postures[0])).head<2>().norm() / step;
  const auto forecast = forecastCentring(fit, postures);
  EXPECT_NEAR(forecast.encoders.median, 1e-4 * lever, 1e-4 * 1e-4 * lever);
  EXPECT_EQ(forecast.encoders.median, forecast.encoders.worst);
}

}  // namespace
}  // namespace tubeplan::calibration
