// Predicted values of each kind of measurement, and their covariance.
#include "calibration/measurements/measurement_prediction.hpp"

#include <gtest/gtest.h>

#include "deflection/rotation.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

const auto kKinds = [] {
  std::vector<MeasurementKind> kinds;
  for (const auto& row : measurementKinds()) kinds.push_back(row.kind);
  return kinds;
}();

Measurement measurement(MeasurementKind kind) {
  Measurement m;
  m.kind = kind;
  m.q = Eigen::Vector4d(25, 70, -60, -20) * kDegree;
  m.load = 30 * kPound;
  m.p_W = Eigen::Vector3d(1.5, -2, 0.4);
  m.direction_W = Eigen::Vector3d(0.6, 0, -0.8);
  m.kind_values = {0.1, 0.2, 0.3};
  if (kindOf(kind).settle) m.surface = Surface{{1.2, -1.7, 0.3}, {0.48, -0.6, 0.64}, 0.1};
  m.sigma = 0.003 * kInch;
  m.turn_sigma = 0.01 * kDegree;
  if (!kindOf(kind).is_from_measurement) return m;
  auto other = std::make_shared<Measurement>(m);
  other->q = Eigen::Vector4d(70, 50, -80, 10) * kDegree;
  other->load = 10 * kPound;
  m.reference = other;
  return m;
}

Eigen::Vector3d tip(const PlacedArm& placed, const Measurement& m, double load) {
  const auto& X_WB = placed.base_poses[0].X_WB;
  const deflection::Posture posture{m.q, load, deflection::gravityInBase(placed.arm, X_WB)};
  return X_WB * deflection::solveFlexibleKinematics(placed.arm, posture, kFine).X_BD.p;
}

TEST(MeasurementPrediction, ValueOfEachKind) {
  const PlacedArm placed = cobra();
  const auto value = [&](MeasurementKind kind) {
    return predictMeasurement(placed.arm, placed.base_poses[0].X_WB, measurement(kind)).value;
  };
  const Measurement m = measurement(MeasurementKind::kPosition);
  const Eigen::Vector3d loaded = tip(placed, m, m.load), bare = tip(placed, m, 0);
  EXPECT_LE((value(MeasurementKind::kPosition) - loaded).norm(), 1e-9);
  EXPECT_LE((value(MeasurementKind::kTouch) - loaded).norm(), 1e-9);
  EXPECT_LE((value(MeasurementKind::kDeflection) - (loaded - bare)).norm(), 1e-9);
  const Measurement from = *measurement(MeasurementKind::kRelative).reference;
  EXPECT_LE((value(MeasurementKind::kRelative) - (loaded - tip(placed, from, from.load))).norm(), 1e-9);
  ASSERT_EQ(value(MeasurementKind::kDistance).size(), 1);
  EXPECT_NEAR(value(MeasurementKind::kDistance)[0], (loaded - *m.p_W).norm(), 1e-9);
  ASSERT_EQ(value(MeasurementKind::kAxis).size(), 1);
  EXPECT_NEAR(value(MeasurementKind::kAxis)[0], m.direction_W->dot(loaded - *m.p_W), 1e-9);
  EXPECT_GT((loaded - bare).norm(), 0.01);
  const Eigen::Matrix3d R = toolAt(placed.arm, placed.base_poses.front().X_WB, m)->R_WT;
  const Eigen::Vector3d up = -placed.arm.gravity_W;
  const Eigen::VectorXd pose = value(MeasurementKind::kPose), turn = value(MeasurementKind::kOrientation) / kTurnLever;
  EXPECT_LE((deflection::rotationFromVector<double>(Eigen::Vector3d(turn)) *
                 deflection::rotationFromFixedAngles<double>(m.kind_values) -
             R)
                .norm(),
            1e-9);
  EXPECT_LE((pose.head(3) - loaded).norm() + (pose.tail(3) / kTurnLever - turn).norm(), 1e-9);
  EXPECT_LE((value(MeasurementKind::kOffset) - R.transpose() * (*m.p_W - loaded)).norm(), 1e-9);
  Measurement upright = measurement(MeasurementKind::kTilt);
  upright.direction_W = up;
  const Eigen::VectorXd tilts = predictMeasurement(placed.arm, placed.base_poses[0].X_WB, upright).value / kTurnLever;
  EXPECT_LE((tilts.array().sin().matrix() - R.transpose() * up).norm(), 1e-9);
  const Surface surface = *measurement(MeasurementKind::kPlane).surface;
  EXPECT_NEAR(value(MeasurementKind::kPlane)[0], surface.direction_W.dot(loaded - surface.p_W), 1e-9);
  EXPECT_NEAR(value(MeasurementKind::kSphere)[0], (loaded - surface.p_W).norm() - surface.radius, 1e-9);
  const Eigen::Vector3d way = loaded - *m.p_W;
  const Eigen::Vector3d polar = value(MeasurementKind::kPolar);
  EXPECT_NEAR(polar[0], way.norm(), 1e-9);
  EXPECT_NEAR(std::tan(polar[1] / kTurnLever + m.kind_values[1]), way.y() / way.x(), 1e-9);
  EXPECT_NEAR(std::sin(polar[2] / kTurnLever), way.z() / way.norm(), 1e-9);
  const Eigen::Vector2d off = value(MeasurementKind::kDirection) / kTurnLever;
  const Eigen::Vector3d seen(std::cos(0.1) * std::cos(0.2), std::sin(0.1) * std::cos(0.2), std::sin(0.2));
  EXPECT_NEAR(std::cos(off.norm()), seen.dot(R.col(0)), 1e-9);
  EXPECT_NEAR(value(MeasurementKind::kSteps)[0], (loaded - *m.p_W).head<2>().norm(), 1e-9);
}

TEST(MeasurementPrediction, DerivativesByTheJointsMatchDifferences) {
  const PlacedArm placed = cobra();
  for (const auto kind : kKinds) {
    const Measurement m = measurement(kind);
    PredictionRequest request;
    request.by_joints = true;
    const auto prediction = predictMeasurement(placed.arm, placed.base_poses[0].X_WB, m, request);
    ASSERT_TRUE(prediction.ok);
    for (int k = 0; k < 4; ++k) {
      constexpr double kStep = 1e-3;
      const auto moved = [&](double h) {
        Measurement other = m;
        other.q[k] += h;
        return predictMeasurement(placed.arm, placed.base_poses[0].X_WB, other).value;
      };
      const Eigen::VectorXd slope =
          (8 * (moved(kStep) - moved(-kStep)) - (moved(2 * kStep) - moved(-2 * kStep))) / (12 * kStep);
      EXPECT_LE((slope - prediction.by_joints.col(k)).norm(), 1e-6) << static_cast<int>(kind) << " " << k;
    }
  }
}

// The predicted covariance agrees with that of randomly drawn measurements. In a deflection, encoder noise displaces
// the loaded and the unloaded tip equally, so it almost cancels.
TEST(MeasurementPrediction, CovarianceIsThatOfDrawnMeasurements) {
  PlacedArm placed = cobra();
  for (auto& row : placed.arm.rows) row.joint.encoder_sigma *= 3;
  const auto& X_WB = placed.base_poses[0].X_WB;
  MeasurementMaker maker(placed, 5, MeasurementMaker::Noise::kStated);
  for (const auto kind : kKinds) {
    const Measurement m = measurement(kind);
    PredictionRequest request;
    request.by_joints = true;
    const auto prediction = predictMeasurement(placed.arm, X_WB, m, request);
    const Eigen::MatrixXd stated = measurementCovariance(placed.arm, m, prediction.by_joints);
    constexpr int kDraws = 6000;
    Eigen::MatrixXd drawn = Eigen::MatrixXd::Zero(stated.rows(), stated.cols());
    for (int n = 0; n < kDraws; ++n) {
      Measurement noisy = m;
      for (int k = 0; k < 4; ++k) noisy.q[k] += maker.noise(0.006 * kDegree);
      if (m.reference) {
        auto other = std::make_shared<Measurement>(*m.reference);
        for (int k = 0; k < 4; ++k) other->q[k] += maker.noise(0.006 * kDegree);
        noisy.reference = other;
      }
      Eigen::VectorXd error = predictMeasurement(placed.arm, X_WB, noisy).value - prediction.value;
      for (Eigen::Index i = 0; i < error.size(); ++i) error[i] += maker.noise(rowSigmas(m)[i]);
      drawn += error * error.transpose() / kDraws;
    }
    // An entry of a sample covariance has a relative sigma of sqrt(2 / n): 0.018.
    EXPECT_LE((drawn - stated).norm(), 0.08 * stated.norm()) << static_cast<int>(kind);
    const double share = 1 - rowSigmas(m).squaredNorm() / stated.trace();
    if (kind == MeasurementKind::kDeflection)
      EXPECT_LT(share, 0.05);
    else
      EXPECT_GT(share, 0.2) << static_cast<int>(kind);
  }
}

TEST(MeasurementPrediction, AMeasurementWithoutSigmaCountsAsExactToAMicrometre) {
  PlacedArm placed = cobra();
  for (auto& row : placed.arm.rows) row.joint.encoder_sigma = 0;
  Measurement m = measurement(MeasurementKind::kPosition);
  m.sigma = std::numeric_limits<double>::quiet_NaN();
  const auto covariance = measurementCovariance(placed.arm, m, Eigen::MatrixXd::Zero(3, 4));
  EXPECT_EQ(covariance, Eigen::MatrixXd(Eigen::Matrix3d::Identity() * 1e-6 * 1e-6));
}

}  // namespace
}  // namespace tubeplan::calibration
