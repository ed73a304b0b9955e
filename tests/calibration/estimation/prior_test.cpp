// Effect of priors on a fit and its covariance, in linear problems with known solutions and for parameters that the
// measurements do not determine.
#include "calibration/estimation/prior.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/fit.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kNone = std::numeric_limits<double>::infinity();

std::vector<Unknown> unknownsWith(const std::vector<double>& prior_sigmas) {
  std::vector<Unknown> unknowns(prior_sigmas.size());
  for (std::size_t k = 0; k < unknowns.size(); ++k) unknowns[k].prior_sigma = prior_sigmas[k];
  return unknowns;
}

MatrixXd randomJacobian(Index rows, Index columns, unsigned seed) {
  std::srand(seed);
  return MatrixXd::Random(rows, columns);
}

TEST(Prior, CovarianceIsTheInverseOfBothInformations) {
  const auto unknowns = unknownsWith({0.5, 2, 1e-3});
  const MatrixXd J = randomJacobian(12, 3, 1);
  MatrixXd information = J.transpose() * J;
  information.diagonal() += Eigen::Vector3d(4, 0.25, 1e6);
  EXPECT_LE((posteriorCovariance(J, unknowns) - MatrixXd(information.inverse())).norm(), 1e-12);
}

TEST(Prior, WithoutMeasurementsTheCovarianceIsThePriors) {
  const auto unknowns = unknownsWith({0.5, 2});
  const MatrixXd C = posteriorCovariance(MatrixXd(0, 2), unknowns);
  EXPECT_NEAR(C(0, 0), 0.25, 1e-15);
  EXPECT_NEAR(C(1, 1), 4, 1e-15);
  EXPECT_NEAR(effectiveNumbers(C, unknowns), 0, 1e-12);
}

TEST(Prior, WithoutPriorsWhatMeasurementsDoNotReachHasNoCovarianceAndIsNotCounted) {
  const auto unknowns = unknownsWith({kNone, kNone});
  MatrixXd J = randomJacobian(6, 2, 2);
  J.col(1).setZero();
  const MatrixXd C = posteriorCovariance(J, unknowns);
  EXPECT_NEAR(C(0, 0), 1 / J.col(0).squaredNorm(), 1e-12);
  EXPECT_EQ(C(1, 1), 0);
  EXPECT_NEAR(effectiveNumbers(C, unknowns), 1, 1e-12);
}

TEST(Prior, TheEffectiveNumberIsTheTraceOfTheHatMatrix) {
  const auto unknowns = unknownsWith({0.3, 0.1, 1});
  const MatrixXd J = randomJacobian(8, 3, 3);
  const MatrixXd C = posteriorCovariance(J, unknowns);
  const double trace = (J * C * J.transpose()).trace();
  EXPECT_NEAR(effectiveNumbers(C, unknowns), trace, 1e-12);
  EXPECT_GT(trace, 0.5);
  EXPECT_LT(trace, 2.5);
}

// The sigmas must not change if the variables are expressed in other units, although those of a compliance and of a
// force then differ by many powers of ten.
TEST(Prior, CovarianceDoesNotHangOnUnits) {
  MeasurementMaker maker(cobra(), 8, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 12);
  PlacedArm placed = cobra();
  auto unknowns = chooseUnknowns(placed, {{"tool.joint_stiffness.z", "forearm.weight.end", "forearm.dh.a"}, true}).list;
  const auto weights = weighMeasurements(placed, maker.measurements);
  const auto n = static_cast<Index>(unknowns.size());
  const MatrixXd J = whitenedResidual(placed, unknowns, maker.measurements, *weights, VectorXd::Zero(n), true).jacobian;
  const VectorXd sigma = posteriorCovariance(J, unknowns).diagonal().cwiseSqrt();
  VectorXd units(n);
  auto scaled = unknowns;
  for (Index k = 0; k < n; ++k) {
    units[k] = std::pow(10., 3. * static_cast<double>(k % 5) - 6);
    scaled[static_cast<std::size_t>(k)].prior_sigma /= units[k];
  }
  const VectorXd in_units = posteriorCovariance(J * units.asDiagonal(), scaled).diagonal().cwiseSqrt();
  for (Index k = 0; k < n; ++k) EXPECT_NEAR(in_units[k] * units[k], sigma[k], 1e-6 * sigma[k]) << k;
}

TEST(Prior, GeometryHasTheDrawingsAndAllOthersAWeakOne) {
  PlacedArm placed = cobra();
  placed.base_poses[0].is_known = false;
  FreeChoice choice{
      {"tool.tip", "forearm.dh.a", "forearm.joint.offset", "latch-link.dh.alpha", "tool.joint_stiffness.z"}, true};
  choice.priors.named["latch-link.dh.alpha"] = 0.007;
  for (const Unknown& unknown : chooseUnknowns(placed, choice).list) {
    const double expected = unknown.name.starts_with("tool.tip")     ? 0.05
                            : unknown.name == "forearm.dh.a"         ? 0.005
                            : unknown.name == "forearm.joint.offset" ? 0.02
                            : unknown.name == "latch-link.dh.alpha"  ? 0.007
                                                                     : 10 * unknown.typical;
    EXPECT_DOUBLE_EQ(unknown.prior_sigma, expected) << unknown.name;
  }
}

TEST(Prior, OfASlideTheOffsetIsALength) {
  PlacedArm placed = cobra();
  placed.arm.rows[2].joint.type = deflection::JointType::kPrismatic;
  const auto offset = chooseUnknowns(placed, {{"base-link.joint.offset"}, false}).list.front();
  EXPECT_EQ(offset.quantity, deflection::Quantity::kLength);
  EXPECT_DOUBLE_EQ(offset.prior_sigma, 0.005);
}

TEST(Prior, MovesWithAnUnknownThatIsRebased) {
  PlacedArm placed = cobra();
  const Unknown unknown = chooseUnknowns(placed, {{"forearm.dh.a"}, false}).list.front();
  const Unknown moved = rebased(unknown, unknown.start + 0.002);
  EXPECT_NEAR(priorResiduals({moved}, VectorXd::Zero(1))[0], 0.4, 1e-12);
  EXPECT_NEAR(priorResiduals({moved}, VectorXd::Constant(1, -0.002))[0], 0, 1e-12);
}

/// Returns noisy measurements of the tip position.
std::vector<Measurement> rigidMeasurements(const PlacedArm& truth, int count) {
  MeasurementMaker maker(truth, 31, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, count);
  return maker.measurements;
}

TEST(Prior, WhatMeasurementsDetermineOnlyTogetherIsSharedByThePriors) {
  PlacedArm start = cobra();
  start.arm = deflection::rigidCopy(start.arm);
  PlacedArm truth = start;
  const auto path = deflection::findParameter(truth.arm, "forearm.dh.d")->path;
  deflection::locate(truth.arm, path) += 0.004;
  FreeChoice choice{{"latch-link.dh.d", "forearm.dh.d", "tool.dh.d"}, false};
  // With half the sigma of the others, it must get a quarter of their correction.
  choice.priors.named["tool.dh.d"] = 0.0025;
  auto unknowns = chooseUnknowns(start, choice).list;
  const auto measurements = rigidMeasurements(truth, 20);
  const Fit fit = fitUnknowns(start, unknowns, measurements, VectorXd::Zero(3), {});
  ASSERT_EQ(fit.solution.status, LeastSquaresStatus::kConverged);
  EXPECT_NEAR(fit.solution.x.sum(), 0.004, 1e-4);
  EXPECT_NEAR(fit.solution.x[0], fit.solution.x[1], 1e-6);
  EXPECT_NEAR(fit.solution.x[2], fit.solution.x[0] / 4, 1e-6);
  EXPECT_NEAR(effectiveNumbers(fit.covariance, unknowns), 1, 0.01);
  EXPECT_EQ(fit.degrees_of_freedom, 59);
}

/// If measurements in a small joint range state a noise a thousand times smaller than the actual errors, the fit must
/// keep close to the drawing, which is correct.
TEST(Prior, HoldsAgainstMeasurementsThatStateFarTooLittleNoise) {
  PlacedArm start = cobra();
  start.arm = deflection::rigidCopy(start.arm);
  for (auto& row : start.arm.rows) row.joint.encoder_sigma = 0;
  MeasurementMaker maker(start, 31, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 15);
  auto measurements = maker.measurements;
  const VectorXd q = measurements.front().q;
  for (auto& measurement : measurements) {
    measurement.q = q + 0.05 * (measurement.q - q);
    measurement.p_W = predictMeasurement(start.arm, start.base_poses[0].X_WB, measurement).value + maker.noise3(2e-3);
    measurement.sigma = 1e-6;
  }
  auto unknowns = chooseUnknowns(start, {{"geometry"}, false}).list;
  const auto zero = VectorXd::Zero(static_cast<Index>(unknowns.size()));
  const Fit fit = fitUnknowns(start, unknowns, measurements, zero, {});
  const Fit blind = fitUnknowns(start, unknowns, measurements, zero, {{}, RobustLoss::kNone, 0.});
  EXPECT_LT(fit.p_value, 1e-10);
  EXPECT_NEAR(fit.weights.model_error, 2e-3, 5e-4);
  EXPECT_LT(priorResiduals(unknowns, fit.solution.x).cwiseAbs().maxCoeff(), 1.5);
  EXPECT_GT(priorResiduals(unknowns, blind.solution.x).norm(), 3 * priorResiduals(unknowns, fit.solution.x).norm());
}

TEST(ModelError, IsFoundBesideTheNoise) {
  for (const double size : {0., 2e-4, 1e-3}) {
    double mean = 0;
    constexpr int kSeeds = 20;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      MeasurementMaker maker(cobra(), static_cast<std::uint64_t>(seed), MeasurementMaker::Noise::kStated);
      maker.add(MeasurementKind::kPosition, 40);
      for (auto& measurement : maker.measurements) *measurement.p_W += maker.noise3(size);
      const auto weights = weighMeasurements(cobra(), maker.measurements);
      const auto residual = whitenedResidual(cobra(), {}, maker.measurements, *weights, {}, false);
      mean += modelErrorOf(maker.measurements, *weights, residual.error, weights->degrees_of_freedom) / kSeeds;
    }
    EXPECT_NEAR(mean, size, size > 0 ? 0.1 * size : 5e-5) << size;
  }
}

/// The model error of distance measurements must be found without bias, although the median of the squared error of
/// their single row is less than half its mean.
TEST(ModelError, IsFoundOfDistancesToo) {
  constexpr double kSize = 1e-3;
  double mean = 0;
  constexpr int kSeeds = 30;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    MeasurementMaker maker(cobra(), static_cast<std::uint64_t>(seed), MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kDistance, 60);
    for (auto& measurement : maker.measurements) measurement.kind_values[0] += maker.noise(kSize);
    const auto weights = weighMeasurements(cobra(), maker.measurements);
    const auto residual = whitenedResidual(cobra(), {}, maker.measurements, *weights, {}, false);
    mean += modelErrorOf(maker.measurements, *weights, residual.error, weights->degrees_of_freedom) / kSeeds;
  }
  EXPECT_NEAR(mean, kSize, 0.04 * kSize);
}

TEST(ModelError, IsNoneWhereThereIsNoFreedomAndWhereTheNoiseIsEnough) {
  MeasurementMaker maker(cobra(), 3, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 10);
  const auto weights = weighMeasurements(cobra(), maker.measurements);
  const auto residual = whitenedResidual(cobra(), {}, maker.measurements, *weights, {}, false);
  EXPECT_EQ(modelErrorOf(maker.measurements, *weights, residual.error, 0), 0);
  EXPECT_EQ(modelErrorOf(maker.measurements, *weights, 0.1 * residual.error, 30), 0);
}

}  // namespace
}  // namespace tubeplan::calibration
