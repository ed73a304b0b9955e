// Profile intervals must equal those from sigma if the model is linear, and must end where chi-square has risen by its
// 95 % quantile if it is not.
#include "calibration/estimation/profile_interval.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/prior.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

struct Fitted {
  PlacedArm start;
  std::vector<Unknown> unknowns;
  std::vector<Measurement> measurements;
  Fit fit;

  [[nodiscard]] double sigmaOf(int k) const { return std::sqrt(fit.covariance(k, k)); }
  [[nodiscard]] ProfileInterval profile(int k) const {
    return profileInterval(start, unknowns, measurements, fit, k, sigmaOf(k));
  }
  /// Returns the minimum of the fit: chi-square of the measurements plus the squared prior residuals.
  [[nodiscard]] double leastChi2() const {
    return fit.solution.chi2 + priorResiduals(unknowns, fit.solution.x).squaredNorm();
  }
};

Fitted fitted(PlacedArm start, const std::vector<Measurement>& measurements, const FreeChoice& choice) {
  Fitted result{std::move(start), {}, measurements, {}};
  result.unknowns = chooseUnknowns(result.start, choice).list;
  const auto n = static_cast<Eigen::Index>(result.unknowns.size());
  result.fit = fitUnknowns(result.start, result.unknowns, result.measurements, Eigen::VectorXd::Zero(n), {});
  EXPECT_EQ(result.fit.solution.status, LeastSquaresStatus::kConverged) << result.fit.solution.reason;
  return result;
}

// Measured positions of a rigid arm depend linearly on the tip's coordinates, so the profile interval must equal the
// normal one.
TEST(ProfileInterval, EqualsTheNormalOneWhereTheModelIsLinear) {
  PlacedArm placed = cobra();
  placed.arm = deflection::rigidCopy(placed.arm);
  MeasurementMaker maker(placed, 3, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 8);
  const Fitted f = fitted(placed, maker.measurements, {{"tool.tip"}, false});
  for (int k = 0; k < 3; ++k) {
    const auto interval = f.profile(k);
    const double half = 1.959964 * f.sigmaOf(k);
    EXPECT_NEAR(interval.lower, f.fit.solution.x[k] - half, 3e-3 * half) << k;
    EXPECT_NEAR(interval.upper, f.fit.solution.x[k] + half, 3e-3 * half) << k;
  }
}

TEST(ProfileInterval, OfASingleUnknownNothingElseIsFittedAgain) {
  PlacedArm placed = cobra();
  placed.arm = deflection::rigidCopy(placed.arm);
  MeasurementMaker maker(placed, 4, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 4);
  const Fitted f = fitted(placed, maker.measurements, {{"tool.tip.x"}, false});
  const auto interval = f.profile(0);
  EXPECT_NEAR(interval.upper - interval.lower, 2 * 1.959964 * f.sigmaOf(0), 0.01 * f.sigmaOf(0));
}

// At each end of the interval, after all other unknowns are refitted, chi-square must have risen by its 95 % quantile,
// 3.84.
TEST(ProfileInterval, EndsWhereTheMisfitHasRisenByItsShare) {
  MeasurementMaker maker(cobra(), 5, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 8);
  const Fitted f = fitted(cobra(), maker.measurements, {{"forearm.joint_stiffness.z", "latch-link.beam.Iz"}, false});
  const double sigma = f.sigmaOf(0);
  const double give = 1 / valueAt(f.unknowns[0], f.fit.solution.x[0]);
  ASSERT_GT(sigma, 0.2 * give) << "not a case where the interval is wide";
  const auto interval = f.profile(0);
  for (const double end : {interval.lower, interval.upper}) {
    if (!std::isfinite(end)) continue;
    auto fixed = f.unknowns;
    fixed[0].lower = fixed[0].upper = end;
    Eigen::VectorXd x = f.fit.solution.x;
    x[0] = end;
    const auto solution = minimizeLeastSquares(fitProblem(f.start, fixed, f.measurements, f.fit.weights, x), {});
    EXPECT_NEAR(solution.chi2 - f.leastChi2(), 3.841459, 0.02);
  }
  // The interval must extend farther upwards, because measurements limit a stiffness less from above than from below.
  const auto [least, most] = valuesBetween(f.unknowns[0], interval.lower, interval.upper);
  EXPECT_GT(most - 1 / give, 1 / give - least);
}

TEST(ProfileInterval, ANumberThatMayBeRigidHasNoUpperEnd) {
  PlacedArm truth = cobra();
  truth.arm.rows[4].joint_stiffness.z() = deflection::kRigid;
  MeasurementMaker maker(truth, 6, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 6);
  for (auto& m : maker.measurements) m.sigma *= 10;
  PlacedArm start = cobra();
  start.arm.rows[4].joint_stiffness.z() *= 20;
  const Fitted f = fitted(start, maker.measurements, {{"forearm.joint_stiffness.z"}, false});
  const auto interval = f.profile(0);
  const auto [least, most] = valuesBetween(f.unknowns[0], interval.lower, interval.upper);
  EXPECT_GT(least, 0);
  EXPECT_EQ(most, deflection::kRigid);
}

}  // namespace
}  // namespace tubeplan::calibration
