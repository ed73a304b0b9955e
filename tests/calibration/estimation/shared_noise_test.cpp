// If several measurements share one reading of the encoders, their common noise must be taken into account.
#include "calibration/estimation/shared_noise.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/repeats.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Returns positions 0 to 5 (three at a first station, two at a second and one at a third), and the displacements from
/// the first station to the positions 2 to 5.
std::vector<Measurement> severalAtAStation() {
  MeasurementMaker maker(cobra(), 21, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 6);
  auto& measurements = maker.measurements;
  measurements[1].q = measurements[2].q = measurements[0].q;
  measurements[4].q = measurements[3].q;
  const auto reference = std::make_shared<const Measurement>(measurements[0]);
  for (int k = 2; k < 6; ++k) {
    Measurement way = measurements[static_cast<std::size_t>(k)];
    way.kind = MeasurementKind::kRelative;
    way.reference = reference;
    way.id += "-way";
    measurements.push_back(way);
  }
  return measurements;
}

MatrixXd slopesOf(const Measurement& measurement) {
  const PlacedArm placed = cobra();
  PredictionRequest request;
  request.by_joints = true;
  return predictMeasurement(placed.arm, placed.base_poses.front().X_WB, measurement, request).by_joints;
}

/// Returns the covariance of all measurements computed directly: encoder noise is common to measurements at one station
/// and independent between stations.
MatrixXd covarianceOf(const std::vector<Measurement>& measurements) {
  const auto arm = cobra().arm;
  const auto n = static_cast<Index>(measurements.size()), joints = arm.jointCount();
  MatrixXd covariance = MatrixXd::Zero(3 * n, 3 * n);
  std::vector<VectorXd> stations;
  std::vector<MatrixXd> by_station;  // 3 n x joints
  const auto columnsAt = [&](const VectorXd& q) -> MatrixXd& {
    for (std::size_t s = 0; s < stations.size(); ++s)
      if (stations[s] == q) return by_station[s];
    stations.push_back(q);
    by_station.push_back(MatrixXd::Zero(3 * n, joints));
    return by_station.back();
  };
  for (Index k = 0; k < n; ++k) {
    const Measurement& measurement = measurements[static_cast<std::size_t>(k)];
    covariance.block<3, 3>(3 * k, 3 * k) = statedCovariance(measurement);
    const MatrixXd slopes = slopesOf(measurement);
    columnsAt(measurement.q).middleRows(3 * k, 3) += slopes.leftCols(joints);
    if (const Measurement* from = referenceOf(measurement))
      columnsAt(from->q).middleRows(3 * k, 3) += slopes.rightCols(joints);
  }
  for (const MatrixXd& columns : by_station)
    for (Index j = 0; j < joints; ++j) {
      const VectorXd column = columns.col(j) * arm.joint(j).encoder_sigma;
      covariance += column * column.transpose();
    }
  return covariance;
}

void expectWhite(const std::vector<Measurement>& measurements, std::size_t shared) {
  const auto weights = weighMeasurements(cobra(), measurements);
  ASSERT_TRUE(weights);
  EXPECT_EQ(weights->shared.size(), shared);
  MatrixXd whitener = MatrixXd::Zero(weights->rows, weights->rows);
  for (std::size_t k = 0; k < measurements.size(); ++k)
    whitener.block<3, 3>(weights->first_row[k], weights->first_row[k]) = weights->whitener[k];
  removeSharedParts(*weights, whitener);
  const MatrixXd covariance = covarianceOf(measurements);
  const MatrixXd white = whitener * covariance * whitener.transpose();
  EXPECT_LE((white - MatrixXd::Identity(weights->rows, weights->rows)).norm(), 1e-6);
  for (std::size_t k = 0; k < measurements.size(); ++k)
    EXPECT_LE((weights->noise[k] - covariance.block<3, 3>(weights->first_row[k], weights->first_row[k])).norm(),
              1e-9 * weights->noise[k].norm())
        << "of a reading alone it is as large";
}

TEST(SharedNoise, IsWhitenedAsTheWholeCovarianceHasIt) {
  expectWhite(severalAtAStation(), 3);  // three stations whose encoder noise several measurements share
}

/// A chain of displacements must be whitened completely, although each of them starts where another ends, so that all
/// are correlated.
TEST(SharedNoise, OfAChainOfWaysIsWhitenedAsTheWholeCovarianceHasIt) {
  MeasurementMaker maker(cobra(), 23, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 12);
  const auto stations = maker.measurements;
  std::vector<Measurement> ways;
  // Displacement from station k to station k + 1, in shuffled order.
  for (const std::size_t k : {3, 0, 7, 10, 1, 5, 2, 8, 4, 9, 6}) {
    Measurement way = stations[k + 1];
    way.kind = MeasurementKind::kRelative;
    way.reference = std::make_shared<const Measurement>(stations[k]);
    ways.push_back(way);
  }
  expectWhite(ways, 10);
}

TEST(SharedNoise, AnArmWithoutEncoderNoiseSharesNone) {
  PlacedArm exact = cobra();
  for (auto& row : exact.arm.rows) row.joint.encoder_sigma = 0;
  const auto weights = weighMeasurements(exact, severalAtAStation());
  ASSERT_TRUE(weights);
  EXPECT_TRUE(weights->shared.empty());
}

TEST(SharedNoise, OfTouchesStaysWithinTheirPoint) {
  MeasurementMaker maker(cobra(), 22, MeasurementMaker::Noise::kStated);
  maker.addTouches(2, {0, 20 * kPound}, false);
  for (auto& measurement : maker.measurements) measurement.q = maker.measurements.front().q;
  const auto weights = weighMeasurements(cobra(), maker.measurements);
  ASSERT_TRUE(weights);
  EXPECT_TRUE(weights->shared.empty()) << "touches of two points at one posture";
  std::erase_if(maker.measurements, [&](const Measurement& m) { return m.point != maker.measurements.front().point; });
  EXPECT_EQ(weighMeasurements(cobra(), maker.measurements)->shared.size(), 1u);
}

/// If three measurements at each of forty postures share one reading of the encoders, their scatter must agree with
/// the stated noise alone.
TEST(SharedNoise, RepeatedShotsAgreeWithTheStatedNoise) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kPosition, 40);
    std::vector<Measurement> shots;
    for (const auto& measurement : maker.measurements)
      for (int shot = 0; shot < 3; ++shot) {
        shots.push_back(measurement);
        shots.back().id += std::string(1, static_cast<char>('a' + shot));
        // The noise that `maker` has already added is common to all three, like an encoder error; here each gets
        // independent noise.
        *shots.back().p_W += maker.noise3(measurement.sigma);
      }
    const auto weights = weighMeasurements(cobra(), shots);
    const auto residual = whitenedResidual(cobra(), {}, shots, *weights, {}, false);
    const auto repeats = judgeRepeats(shots, *weights, residual.error, residual.r.squaredNorm(), weights->rows);
    EXPECT_EQ(repeats.groups, 40);
    refused += repeats.noise_p_value < 0.01;
  }
  EXPECT_LE(refused, 2) << "of 20 at the level of 0.01";
}

}  // namespace
}  // namespace tubeplan::calibration
