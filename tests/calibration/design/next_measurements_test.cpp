// Proposals for the next measurements, tested with the Cobra arm.
#include "calibration/design/next_measurements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::calibration {
namespace {

using deflection::cobraArm, deflection::randomJoints;
using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kSigma = 0.003 * kInch;
const FreeChoice kStiffnesses{
    {"tool.joint_stiffness.z", "latch-link.beam.Iz", "mezzanine-beam.beam.Iz", "mezzanine-platform.joint_stiffness.x"},
    false};

ProposedMeasurement positionAt(const VectorXd& q, double load) {
  ProposedMeasurement measurement;
  measurement.q = q;
  measurement.load = load;
  measurement.sigma = kSigma;
  return measurement;
}

std::vector<MeasurementCandidate> randomCandidates(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<MeasurementCandidate> candidates;
  for (int k = 0; k < count; ++k)
    candidates.push_back({{positionAt(randomJoints(cobraArm(), random), (k % 3) * 20 * kPound)}});
  return candidates;
}

Work randomWork(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Work work;
  for (int k = 0; k < count; ++k) work.postures.push_back(randomJoints(cobraArm(), random));
  return work;
}

/// Simulates the planned measurement with the given arm, with noise in the position and the joint readings.
Measurement read(const ProposedMeasurement& planned, const deflection::Arm& arm, std::mt19937_64& random) {
  Measurement measurement = conditionsOf(planned);
  std::normal_distribution<double> normal(0, 1);
  Eigen::Vector3d place = predictMeasurement(arm, Eigen::Isometry3d::Identity(), measurement).value;
  for (double& x : place) x += kSigma * normal(random);
  measurement.p_W = place;
  for (double& q : measurement.q) q += arm.rows.back().joint.encoder_sigma * normal(random);
  return measurement;
}

std::vector<Measurement> measurementsOf(const deflection::Arm& arm, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Measurement> measurements;
  for (const auto& candidate : randomCandidates(count, seed + 100)) {
    measurements.push_back(read(candidate.measurements.front(), arm, random));
    measurements.back().id = std::to_string(measurements.size());
  }
  return measurements;
}

Estimate fromNothing(const FreeChoice& free, bool base_known = true) {
  return estimateFrom(cobraArm(), Eigen::Isometry3d::Identity(), base_known, {}, free);
}

/// Returns the predicted value of a measurement after the named stiffness is multiplied by exp(`step`).
VectorXd movedBy(const Measurement& measurement, const std::string& name, double step) {
  deflection::Arm arm = cobraArm();
  double& number = deflection::locate(arm, deflection::findParameter(arm, name)->path);
  number *= std::exp(step);
  return predictMeasurement(arm, Eigen::Isometry3d::Identity(), measurement).value;
}

// The forecast sigmas must equal those of generalised least squares with a Jacobian from difference quotients and the
// full covariance of the coordinates, including encoder noise.
TEST(NextMeasurements, CovarianceIsThatOfGeneralisedLeastSquaresByDifferences) {
  const auto estimate = fromNothing(kStiffnesses);
  const auto candidates = randomCandidates(30, 5);
  NextMeasurementsOptions options;
  options.design.count = 7;
  const auto next = proposeMeasurements(estimate, candidates, randomWork(10, 6), options);
  ASSERT_EQ(next.status, NextMeasurementsStatus::kDone);
  const int n = static_cast<int>(kStiffnesses.names.size()), rows = 3 * options.design.count;
  MatrixXd J(rows, n), noise = MatrixXd::Identity(rows, rows) * kSigma * kSigma;
  for (int s = 0; s < options.design.count; ++s) {
    const int index =
        next.candidates[static_cast<std::size_t>(next.design.steps[static_cast<std::size_t>(s)].candidate)];
    const Measurement measurement = conditionsOf(candidates[static_cast<std::size_t>(index)].measurements.front());
    for (int k = 0; k < n; ++k) {
      const auto& name = kStiffnesses.names[static_cast<std::size_t>(k)];
      J.block<3, 1>(3 * s, k) = (movedBy(measurement, name, 1e-4) - movedBy(measurement, name, -1e-4)) / 2e-4;
    }
    for (int joint = 0; joint < 4; ++joint) {
      auto more = measurement, less = measurement;
      more.q[joint] += 1e-5;
      less.q[joint] -= 1e-5;
      const VectorXd column =
          (movedBy(more, "tool.joint_stiffness.z", 0) - movedBy(less, "tool.joint_stiffness.z", 0)) / 2e-5 *
          cobraArm().rows.back().joint.encoder_sigma;
      noise.block<3, 3>(3 * s, 3 * s) += column * column.transpose();
    }
  }
  const MatrixXd covariance = (J.transpose() * noise.inverse() * J + MatrixXd::Identity(n, n)).inverse();
  EXPECT_LT((next.design.covariance - covariance).norm(), 1e-4 * covariance.norm());
  for (int k = 0; k < n; ++k) {
    const auto& number = next.numbers[static_cast<std::size_t>(k)];
    EXPECT_NEAR(number.after, number.value * std::sqrt(covariance(k, k)), 1e-4 * number.after);
    EXPECT_NEAR(number.now, number.value,
                1e-9 * number.value);  // before any measurement, sigma is the standard deviation of the prior
    EXPECT_FALSE(number.is_identifiable_now);
  }
}

TEST(NextMeasurements, PromisesWhatAFitThenReaches) {
  const auto estimate = fromNothing(kStiffnesses);
  const auto candidates = randomCandidates(120, 7);
  const Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  NextMeasurementsOptions proposal;
  proposal.design.count = 6;
  const auto next = proposeMeasurements(estimate, candidates, randomWork(10, 8), proposal);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1);
  constexpr int kRuns = 40;
  VectorXd square = VectorXd::Zero(4);
  for (int run = 0; run < kRuns; ++run) {
    std::vector<Measurement> measurements;
    for (const auto& step : next.design.steps) {
      const int index = next.candidates[static_cast<std::size_t>(step.candidate)];
      measurements.push_back(
          read(candidates[static_cast<std::size_t>(index)].measurements.front(), cobraArm(), random));
    }
    IdentificationOptions options;
    options.free = kStiffnesses;
    options.folds = 0;
    options.intervals_by_profile = false;
    const auto fit = identify(cobraArm(), X_WB, true, measurements, options);
    ASSERT_EQ(fit.status, IdentificationStatus::kDone) << fit.reason;
    for (int k = 0; k < 4; ++k) {
      const auto& number = fit.numbers[static_cast<std::size_t>(k)];
      square[k] += std::pow(number.value - number.unknown.start, 2) / kRuns;
    }
  }
  // Forty runs determine a standard deviation to within 11 %; the tolerance is three times that.
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(std::sqrt(square[k]) / next.numbers[static_cast<std::size_t>(k)].after, 1, 0.34) << k;
}

TEST(NextMeasurements, NowIsWhatIdentifyReports) {
  const auto measurements = measurementsOf(cobraArm(), 40, 11);
  IdentificationOptions options;
  options.free = kStiffnesses;
  options.folds = 0;
  options.intervals_by_profile = false;
  const auto fit = identify(cobraArm(), Eigen::Isometry3d::Identity(), true, measurements, options);
  const auto estimate = estimateFrom(cobraArm(), Eigen::Isometry3d::Identity(), true, measurements, kStiffnesses);
  EXPECT_EQ(estimate.note, "");
  const auto next = proposeMeasurements(estimate, randomCandidates(60, 12), randomWork(10, 13));
  ASSERT_EQ(next.numbers.size(), fit.numbers.size());
  for (std::size_t k = 0; k < fit.numbers.size(); ++k) {
    EXPECT_NEAR(next.numbers[k].now, fit.numbers[k].sigma, 0.01 * fit.numbers[k].sigma);
    EXPECT_NEAR(next.numbers[k].value, fit.numbers[k].value, 1e-9 * fit.numbers[k].value);
    EXPECT_LT(next.numbers[k].after, next.numbers[k].now);
    EXPECT_TRUE(next.numbers[k].is_identifiable_now);
  }
}

class NextMeasurementsBySeed : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, NextMeasurementsBySeed, ::testing::Values(1, 2, 3));

TEST_P(NextMeasurementsBySeed, ChosenMeasurementsBeatRandomOnes) {
  const auto estimate = fromNothing(kStiffnesses);
  NextMeasurementsOptions options;
  options.seed = GetParam();
  options.design.count = 5;
  const auto candidates = randomCandidates(150, GetParam());
  const auto work = randomWork(20, GetParam() + 50);
  const auto in_all = proposeMeasurements(estimate, candidates, work, options);
  EXPECT_GT(in_all.bits, in_all.bits_random);
  options.design.optimality = Optimality::kWorstTip;
  const auto at_worst = proposeMeasurements(estimate, candidates, work, options);
  EXPECT_LT(at_worst.tip_after.worst, at_worst.tip_random.worst);
  EXPECT_LE(at_worst.tip_after.worst, in_all.tip_after.worst);
  EXPECT_LT(at_worst.tip_after.worst, at_worst.tip_now.worst);
}

TEST(NextMeasurements, OneTouchOfAnUnknownPointTellsNothingButTwoLoadsDo) {
  const auto estimate = fromNothing(kStiffnesses);
  std::mt19937_64 random(21);
  std::vector<MeasurementCandidate> once, twice;
  for (int k = 0; k < 12; ++k) {
    ProposedMeasurement touch = positionAt(randomJoints(cobraArm(), random), 0);
    touch.kind = MeasurementKind::kTouch;
    ProposedMeasurement loaded = touch;
    loaded.load = 30 * kPound;
    once.push_back({{touch}});
    twice.push_back({{touch, loaded}});
  }
  const Work work = randomWork(5, 22);
  NextMeasurementsOptions options;
  options.design.count = 4;
  EXPECT_NEAR(proposeMeasurements(estimate, once, work, options).bits, 0, 1e-6);
  EXPECT_GT(proposeMeasurements(estimate, twice, work, options).bits, 5);
}

TEST(NextMeasurements, APlacingIsLearntWithTheNumbers) {
  FreeChoice free = kStiffnesses;
  free.base = true;
  const auto estimate = fromNothing(free, false);
  ASSERT_EQ(estimate.unknowns.size(), 10u);
  const auto next = proposeMeasurements(estimate, randomCandidates(80, 31), randomWork(10, 32));
  for (const auto& number : next.numbers) EXPECT_TRUE(number.is_identifiable_after) << number.unknown.name;
  EXPECT_GT(next.tip_now.rms, 1);
  EXPECT_LT(next.tip_after.rms, 0.01 * kInch);
}

TEST(NextMeasurements, NamesThatAreNoNumbersAreTold) {
  const auto estimate = fromNothing({{"forearm.dh.aa"}, false});
  ASSERT_EQ(estimate.problems.size(), 1u);
  EXPECT_EQ(estimate.problems.front().name, "forearm.dh.aa");
}

TEST(NextMeasurements, MeasurementsThatCannotBeFittedAreCountedWhereTheDrawingStands) {
  auto measurements = measurementsOf(cobraArm(), 1, 41);
  const auto estimate = estimateFrom(cobraArm(), Eigen::Isometry3d::Identity(), true, measurements, kStiffnesses);
  EXPECT_NE(estimate.note, "");
  EXPECT_EQ(estimate.x, VectorXd::Zero(4));
  EXPECT_GT((estimate.information - MatrixXd::Identity(4, 4)).norm(), 1);
}

// If the candidates' loads are so large that the arm has no equilibrium at any of them, the proposal must be refused.
TEST(NextMeasurements, AreRefusedWhereNoCandidateCanBeMade) {
  std::mt19937_64 random(9);
  std::vector<MeasurementCandidate> candidates;
  for (int k = 0; k < 5; ++k) candidates.push_back({{positionAt(randomJoints(cobraArm(), random), 5e4 * kPound)}});
  const auto next = proposeMeasurements(fromNothing(kStiffnesses), candidates, randomWork(5, 3));
  EXPECT_EQ(next.status, NextMeasurementsStatus::kTooFewCandidates) << next.reason;
}

}  // namespace
}  // namespace tubeplan::calibration
