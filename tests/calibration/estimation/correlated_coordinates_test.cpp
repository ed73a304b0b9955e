// Measurements with correlated coordinate errors must be weighted by their full covariance, which makes a fit more
// accurate.
#include <gtest/gtest.h>

#include "calibration/estimation/identification.hpp"
#include "calibration/measurement_checks/axes.hpp"
#include "calibration/measurement_checks/shifted_rows.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d;

Measurement correlated(MeasurementKind kind) {
  Measurement m;
  m.kind = kind;
  m.p_W = Vector3d(1, 2, 3);
  m.kind_values.setZero();
  m.sigma_W = Vector3d(1e-4, 5e-4, 2e-4);
  m.correlation_W = Vector3d(0.9, -0.5, -0.3);
  m.sigma = 3e-4;
  m.turn_sigma = 1e-4;
  return m;
}

TEST(CorrelatedCoordinates, WeighByTheirWholeCovariance) {
  for (const auto& row : measurementKinds()) {
    const Measurement m = correlated(row.kind);
    Measurement uncorrelated = m;
    uncorrelated.correlation_W.reset();
    const MatrixXd with = statedCovariance(m), without = statedCovariance(uncorrelated);
    EXPECT_TRUE(with.diagonal().isApprox(without.diagonal())) << row.name;
    MatrixXd expected = without;
    if (row.has_coordinates) {
      expected(0, 1) = expected(1, 0) = 0.9 * 1e-4 * 5e-4;
      expected(0, 2) = expected(2, 0) = -0.5 * 1e-4 * 2e-4;
      expected(1, 2) = expected(2, 1) = -0.3 * 5e-4 * 2e-4;
    }
    EXPECT_TRUE(with.isApprox(expected)) << row.name;
  }
}

TEST(CorrelatedCoordinates, AreThoseOfAPositiveDefiniteCovariance) {
  EXPECT_TRUE(isPossibleCorrelation({0.9, 0.9, 0.9}));
  EXPECT_TRUE(isPossibleCorrelation({0, 0, -0.999}));
  EXPECT_FALSE(isPossibleCorrelation({0.9, 0.9, -0.9})) << "each possible, not the three";
  EXPECT_FALSE(isPossibleCorrelation({1, 0, 0}));
  EXPECT_FALSE(isPossibleCorrelation({0, -1.5, 0}));
  EXPECT_FALSE(isPossibleCorrelation({0, std::numeric_limits<double>::quiet_NaN(), 0}));
}

// If the coordinates are rotated into the world's axes (here x, y, z of the file are -y, x, z of the world), the
// covariance must be rotated with them.
TEST(CorrelatedCoordinates, TurnWithTheAxesThatTheyAreWrittenIn) {
  const Measurement m = correlated(MeasurementKind::kPosition);
  const Matrix3d to_world = *mistakes::axes::matrixOf("-yxz");
  std::vector<Measurement> turned{m};
  mistakes::axes::turn(to_world, turned);
  const Matrix3d before = statedCovariance(m), after = statedCovariance(turned.front());
  EXPECT_TRUE(after.isApprox(to_world * before * to_world.transpose()));
  EXPECT_FALSE(after.isApprox(before));
}

TEST(CorrelatedCoordinates, GoWithWhatWasMeasuredWhereRowsAreShifted) {
  std::vector<Measurement> measurements(3, correlated(MeasurementKind::kPosition));
  for (std::size_t k = 0; k < 3; ++k) (*measurements[k].correlation_W)[0] = 0.1 * static_cast<double>(k);
  mistakes::shifted_rows::shift(1, measurements);
  ASSERT_EQ(measurements.size(), 2u);
  EXPECT_EQ((*measurements[0].correlation_W)[0], 0.1);
  EXPECT_EQ((*measurements[1].correlation_W)[0], 0.2);
}

/// Number of 95 % intervals, number of those that contain the true value, and sum of their relative widths.
struct IntervalCoverage {
  int covered = 0, count = 0;
  double width = 0;
};

void fit(const PlacedArm& truth, const std::vector<Measurement>& measurements, const std::vector<std::string>& names,
         IntervalCoverage& coverage) {
  IdentificationOptions options;
  options.free = {names, false};
  options.folds = 0;
  options.intervals_by_profile = false;
  const auto result = identify(truth, measurements, options);
  ASSERT_EQ(result.status, IdentificationStatus::kDone);
  for (const auto& number : result.numbers) {
    const double value = deflection::findParameter(truth.arm, number.unknown.name)->value;
    ++coverage.count;
    coverage.covered += number.lower <= value && value <= number.upper;
    // Width of the compliance interval, relative to the true compliance.
    coverage.width += (1 / number.lower - 1 / number.upper) * value;
  }
}

// If correlations are stated, 95 % intervals must contain the true value in 95 % of the cases, and be less than half as
// wide as intervals without them. The tracker's noise is 0.001 in along x and 0.005 in across, with correlations of
// 0.9. The encoder noise is reduced, so that the tracker's noise dominates.
TEST(CorrelatedCoordinates, IntervalsHoldTheTruthAndAreSharperForIt) {
  const std::vector<std::string> names{"tool.joint_stiffness.z", "forearm.joint_stiffness.z",
                                       "mezzanine-beam.joint_stiffness.z", "mezzanine-platform.joint_stiffness.x"};
  PlacedArm truth = cobra();
  for (auto& row : truth.arm.rows) row.joint.encoder_sigma /= 20;
  IntervalCoverage correlated, uncorrelated;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    MeasurementMaker maker(truth, seed, MeasurementMaker::Noise::kStated);
    maker.sigma_W = Vector3d(0.001, 0.005, 0.005) * kInch;
    maker.correlation_W = Vector3d(0.9, 0.9, 0.9);
    maker.add(MeasurementKind::kPosition, 40);
    fit(truth, maker.measurements, names, correlated);
    for (auto& measurement : maker.measurements) measurement.correlation_W.reset();
    fit(truth, maker.measurements, names, uncorrelated);
  }
  ASSERT_EQ(correlated.count, 800);
  EXPECT_GE(correlated.covered, 0.93 * 800);
  EXPECT_LE(correlated.covered, 0.97 * 800);
  EXPECT_LT(correlated.width, 0.5 * uncorrelated.width);
}

}  // namespace
}  // namespace tubeplan::calibration
