// The discrepancy of a relative measurement must be the difference between the discrepancies at its two postures.
#include "calibration/diagnosis/discrepancy/discrepancy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "calibration/diagnosis/diagnosis.hpp"
#include "tests/calibration/bench_measurements.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Hidden joint error [rad] with three waves per turn of the third joint; no effect of the catalogue has this form.
double hiddenAt(const VectorXd& q) { return 0.0012 * std::sin(3 * q[2] + 1); }

void hideInMeasurements(std::vector<Measurement>& measurements) {
  for (auto& measurement : measurements) {
    measurement.q[2] -= hiddenAt(measurement.q);
    if (!measurement.reference) continue;
    auto from = std::make_shared<Measurement>(*measurement.reference);
    from->q[2] -= hiddenAt(from->q);
    measurement.reference = from;
  }
}

std::vector<Measurement> ways(const PlacedArm& truth, int count, std::uint64_t seed, MeasurementMaker::Noise noise) {
  MeasurementMaker maker(truth, seed, noise);
  maker.add(MeasurementKind::kRelative, count);
  hideInMeasurements(maker.measurements);
  return std::move(maker.measurements);
}

/// Returns the fraction of the squared error that the discrepancy process explains, given the noise of the
/// measurements.
double shareTaken(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  const auto weights = weighMeasurements(placed, measurements);
  const Discrepancy process(placed, measurements);
  const MatrixXd columns = process.columnsAt(measurements, *weights);
  const VectorXd error = whitenedResidual(placed, {}, measurements, *weights, VectorXd(0), false).r;
  constexpr double kSize = 0.002;  // [m], standard deviation of the process
  const MatrixXd scaled = kSize * columns;
  MatrixXd inner = MatrixXd::Identity(scaled.cols(), scaled.cols());
  inner += scaled.transpose() * scaled;
  const VectorXd residual = error - scaled * inner.llt().solve(scaled.transpose() * error);
  return 1 - residual.squaredNorm() / error.squaredNorm();
}

TEST(Discrepancy, OfWaysIsTheDifferenceAtBothEnds) {
  const PlacedArm placed = cobra();
  const auto measurements = ways(placed, 400, 3, MeasurementMaker::Noise::kNone);
  EXPECT_GT(shareTaken(placed, measurements), 0.99);
}

// If a relative measurement starts and ends at the same posture, the discrepancy must not change it.
TEST(Discrepancy, OfAWayToWhereItBeganIsNothing) {
  const PlacedArm placed = cobra();
  auto measurements = ways(placed, 40, 4, MeasurementMaker::Noise::kNone);
  for (std::size_t k = 0; k < 20; ++k) {
    auto from = std::make_shared<Measurement>(measurements[k]);
    from->reference = nullptr;
    measurements[k].reference = from;
  }
  const auto weights = weighMeasurements(placed, measurements);
  const MatrixXd columns = Discrepancy(placed, measurements).columnsAt(measurements, *weights);
  EXPECT_LE(columns.topRows(60).norm(), 1e-9 * columns.norm());
  EXPECT_GT(columns.bottomRows(60).norm(), 0.5 * columns.norm());
}

TEST(Discrepancy, HiddenInWaysIsRecognisedAsARemainderOfItsJoint) {
  const auto cell = shippedBench();
  const PlacedArm truth{cell.arm, {{"", cell.X_WB, true}}};
  const auto measurements = ways(truth, 120, 6, MeasurementMaker::Noise::kStated);
  DiagnosisOptions options;
  options.baseline.free = {cell.identify, false};
  const Diagnosis found = diagnose(truth, measurements, options);
  EXPECT_EQ(found.verdict, Verdict::kUnexplained);
  EXPECT_FALSE(found.isScatterAlone());
  ASSERT_FALSE(found.remainder.follows.empty());
  EXPECT_EQ(found.remainder.follows.front().first, "theta3");
}

}  // namespace
}  // namespace tubeplan::calibration
