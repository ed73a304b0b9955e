// A pattern search must find patterns that were added to the residual, with no more false findings than the
// significance level allows.
#include "calibration/patterns/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/measurements/measurement_placement.hpp"
#include "tests/calibration/campaign.hpp"
#include "tests/calibration/synthetic_measurements.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Isometry3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

ComparisonOptions refitOf(const std::vector<std::string>& names) {
  ComparisonOptions options;
  options.refit.free = {names, true};
  options.refit.folds = 0;
  options.refit.intervals_by_profile = false;
  return options;
}

const std::vector<std::string> kTwoStiffnesses = {"tool.joint_stiffness.z", "forearm.joint_stiffness.z"};

Comparison compareCobra(const std::vector<Measurement>& measurements,
                        const std::vector<std::string>& free = kTwoStiffnesses) {
  return compare(placeForMeasurements(deflection::cobraArm(), Isometry3d::Identity(), true, measurements), measurements,
                 refitOf(free));
}

/// Linear model: a given Jacobian, and random residuals from which the components that the Jacobian absorbs are
/// removed.
struct LinearWorld {
  MeasurementScene scene;
  MeasurementWeights weights;
  WhitenedResidual residual;
  MatrixXd Q;

  explicit LinearWorld(const std::vector<Measurement>& measurements) {
    PlacedArm placed = placeForMeasurements(deflection::cobraArm(), Isometry3d::Identity(), false, measurements);
    const auto unknowns = chooseUnknowns(placed, {kTwoStiffnesses, true}).list;
    scene = observe(placed, measurements);
    weights = *weighMeasurements(placed, measurements);
    residual = whitenedResidual(placed, unknowns, measurements, weights,
                                VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size())), true);
    Q = MatrixXd(residual.jacobian.householderQr().householderQ()).leftCols(residual.jacobian.cols());
  }

  PatternSearch search(std::uint64_t seed, double noise, double level) {
    boost::random::mt19937_64 random(seed);
    boost::random::normal_distribution<double> normal;
    for (auto& r : residual.r) r = noise * normal(random);
    residual.r -= (Q * (Q.transpose() * residual.r)).eval();
    return searchPatterns(scene, weights, residual, level);
  }
};

// For a relative measurement, `seen` must be the displacement from the reference, because the error of the measured
// length lies along this vector.
TEST(Comparison, theErrorOfAWayLiesAlongIt) {
  MeasurementMaker maker(cobra(), 4, MeasurementMaker::Noise::kNone);
  maker.add(MeasurementKind::kRelative, 6);
  const auto scene = observe(cobra(), maker.measurements);
  ASSERT_TRUE(scene.ok);
  for (std::size_t k = 0; k < maker.measurements.size(); ++k)
    EXPECT_LE((scene.seen.col(static_cast<Eigen::Index>(k)) - *maker.measurements[k].p_W).norm(), 1e-4)
        << "the way read";
}

TEST(Comparison, noiseShowsPatternsNoOftenerThanPromised) {
  LinearWorld world(makeCampaign(deflection::cobraArm(), 3));
  constexpr int kSeeds = 400;
  int false_findings = 0, single_tests = 0, single_hits = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto found = world.search(static_cast<std::uint64_t>(seed), 1, 0.05);
    ASSERT_GT(found.tests.size(), 60u);
    false_findings += !found.findings.empty();
    single_tests += static_cast<int>(found.tests.size());
    for (const auto& test : found.tests) single_hits += test.p_value < 0.05;
  }
  RecordProperty("false_findings", false_findings);
  RecordProperty("single_hits_permille", 1000 * single_hits / single_tests);
  EXPECT_LE(false_findings, kSeeds / 20);
  EXPECT_GT(false_findings, 0) << "a correction that never lets any through hides real ones too";
  EXPECT_NEAR(static_cast<double>(single_hits) / single_tests, 0.05, 0.01);
}

TEST(Comparison, whatIsFollowedDoesNotDependOnTheSizeOfTheNoise) {
  LinearWorld world(makeCampaign(deflection::cobraArm(), 3));
  const auto once = world.search(7, 1, 0.01), tenfold = world.search(7, 10, 0.01);
  ASSERT_EQ(once.tests.size(), tenfold.tests.size());
  for (std::size_t k = 0; k < once.tests.size(); ++k) {
    EXPECT_NEAR(once.tests[k].p_value, tenfold.tests[k].p_value, 1e-9);
    EXPECT_NEAR(10 * once.tests[k].size, tenfold.tests[k].size, 1e-9);
  }
}

TEST(Comparison, holmsCorrectionMultipliesByTheTestsThatAreLeft) {
  LinearWorld world(makeCampaign(deflection::cobraArm(), 3));
  const auto tests = world.search(11, 1, 0.01).tests;
  double largest = 0;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    largest = std::max(largest, std::min(1., tests[k].p_value * static_cast<double>(tests.size() - k)));
    EXPECT_DOUBLE_EQ(tests[k].p_corrected, largest);
    EXPECT_EQ(tests[k].is_finding, largest <= 0.01);
  }
}

TEST(Comparison, aRightModelIsAdequateBeforeAndAfter) {
  constexpr int kSeeds = 20;
  int short_before = 0, short_after = 0;
  double chi2 = 0, freedom = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto result = compareCobra(makeCampaign(deflection::cobraArm(), 100 + static_cast<std::uint64_t>(seed)));
    ASSERT_EQ(result.status, ComparisonStatus::kDone) << result.reason;
    EXPECT_EQ(result.as_it_stands.degrees_of_freedom, 3 * 36);
    EXPECT_EQ(result.after_refit.degrees_of_freedom, 3 * 36 - 2);
    EXPECT_LE(result.after_refit.chi2, result.as_it_stands.chi2 * (1 + 1e-3));
    short_before += result.as_it_stands.adequacy == Adequacy::kInadequate;
    short_after += result.verdict == Adequacy::kInadequate;
    chi2 += result.after_refit.chi2;
    freedom += result.after_refit.degrees_of_freedom;
  }
  EXPECT_LE(short_before, 2);
  EXPECT_LE(short_after, 2);
  EXPECT_NEAR(chi2 / freedom, 1, 4 * std::sqrt(2 / freedom));
}

TEST(Comparison, plantedHysteresisIsFoundByTheJointsSense) {
  for (const char* joint : {"theta1", "theta2", "theta3"}) {
    const auto truth = withEffect(deflection::cobraArm(), "hysteresis", joint, 0.03 * kDegree);
    const auto result = compareCobra(makeCampaign(truth, 5));
    EXPECT_EQ(result.verdict, Adequacy::kInadequate);
    ASSERT_FALSE(result.patterns.findings.empty());
    const auto& first = result.patterns.findings.front();
    EXPECT_EQ(first.kind, "sense");
    EXPECT_EQ(first.variable, std::string("sense of ") + joint);
    EXPECT_TRUE(first.goes_with.empty());
    ASSERT_EQ(first.trend.size(), 2u);
    // Between the two approach directions, the tip moves by two half-widths of the hysteresis times its lever arm.
    const double lever = 2 * 0.03 * kDegree * deflection::reachOf(deflection::cobraArm());
    EXPECT_GT(first.size, 0.1 * lever);
    EXPECT_LT(first.size, lever);
  }
}

TEST(Comparison, plantedGrowthIsFoundByTemperature) {
  const auto truth = withEffect(deflection::cobraArm(), "thermal-growth", "arm", 5e-5);
  const auto result = compareCobra(makeCampaign(truth, 6));
  EXPECT_EQ(result.verdict, Adequacy::kInadequate);
  ASSERT_FALSE(result.patterns.findings.empty());
  const auto& first = result.patterns.findings.front();
  EXPECT_EQ(first.variable, "temperature");
  EXPECT_EQ(first.frame, PatternFrame::kRadial);
  EXPECT_NE(first.component, 1) << "links that grow move the tip in the arm's plane";
  EXPECT_EQ(first.high, static_cast<int>(first.trend.size()) - 1) << "the model predicts too little where it is warm";
}

TEST(Comparison, whatGoesWithAConditionIsFoundByIt) {
  const auto isCondition = [](const std::string& name) {
    return std::ranges::any_of(deflection::kConditionKinds, [&](const auto& kind) { return kind.name == name; });
  };
  for (const auto& kind : deflection::kConditionKinds) {
    auto measurements = makeCampaign(deflection::cobraArm(), 6);
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      const double share = std::fmod(0.618034 * static_cast<double>(k), 1);
      measurements[k].conditions = {};
      measurements[k].conditions[kind.condition] = kind.usual + 10 * share;
      measurements[k].p_W->z() += 30 * kMeasurementSigma * share;
    }
    const auto result = compareCobra(measurements);
    EXPECT_EQ(result.verdict, Adequacy::kInadequate) << kind.name;
    ASSERT_FALSE(result.patterns.findings.empty()) << kind.name;
    EXPECT_EQ(result.patterns.findings.front().kind, kind.name);
    EXPECT_EQ(result.patterns.findings.front().variable, kind.name);
    for (const auto& test : result.patterns.tests)
      EXPECT_TRUE(test.kind == kind.name || !isCondition(test.kind)) << test.kind << " is not stated";
  }
}

TEST(Comparison, aPlantedOffsetIsSeenAndGoneOnceItIsFitted) {
  const auto truth = withEffect(deflection::cobraArm(), "joint-offset", "theta3", 0.1 * kDegree);
  const auto measurements = makeCampaign(truth, 8);
  const auto without = compareCobra(measurements);
  EXPECT_EQ(without.verdict, Adequacy::kInadequate);
  EXPECT_FALSE(without.patterns.findings.empty());
  const auto with = compareCobra(measurements, {"forearm.joint.offset", "tool.joint_stiffness.z"});
  EXPECT_EQ(with.as_it_stands.adequacy, Adequacy::kInadequate);
  EXPECT_EQ(with.verdict, Adequacy::kAdequate);
  EXPECT_TRUE(with.patterns.findings.empty());
  EXPECT_GT(with.as_it_stands.errors.rms, 5 * with.after_refit.errors.rms);
  EXPECT_LT(with.after_refit.errors.rms, 1.3 * with.after_refit.noise_floor);
}

TEST(Comparison, nothingFreeIsJudgedAsItStands) {
  const auto result = compareCobra(makeCampaign(deflection::cobraArm(), 9), {});
  EXPECT_EQ(result.status, ComparisonStatus::kDone);
  EXPECT_EQ(result.refit.status, IdentificationStatus::kNotRun);
  EXPECT_DOUBLE_EQ(result.as_it_stands.chi2, result.after_refit.chi2);
  EXPECT_EQ(result.verdict, Adequacy::kAdequate);
}

TEST(Comparison, whatOnlyNoiseMovesIsNotAsked) {
  // If holes of a flat sheet are touched, the predicted height varies only because of the error, so the height must not
  // be tested. Neither may joints and positions be tested that do not vary beyond noise.
  auto measurements = makeCampaign(deflection::cobraArm(), 21);
  for (auto& measurement : measurements) {
    const Vector3d tip = *measurement.p_W;
    measurement.kind = MeasurementKind::kTouch;
    measurement.point = measurement.id;
    measurement.p_W = Vector3d(tip.x(), tip.y(), 1);
  }
  const auto placed = placeForMeasurements(deflection::cobraArm(), Isometry3d::Identity(), true, measurements);
  const auto names = [](const MeasurementScene& scene, const std::string& kind_name) {
    std::vector<std::string> list;
    for (const auto& kind : patternKinds())
      if (kind.name == kind_name)
        for (const auto& variable : kind.variables(scene)) list.push_back(variable.name);
    return list;
  };
  EXPECT_EQ(names(observe(placed, measurements), "position"), (std::vector<std::string>{"position x", "position y"}));
  EXPECT_EQ(names(observe(placed, measurements), "joint").size(), 8u) << "each joint, and its cycles";
  const auto still = makeCampaign(deflection::cobraArm(), 22, {1, 40, kMeasurementSigma, kMeasurementSigma});
  EXPECT_TRUE(names(observe(placed, still), "joint").empty());
  EXPECT_TRUE(names(observe(placed, still), "position").empty());
}

TEST(Comparison, worstMeasurementIsTheOneThatWasSpoiled) {
  auto measurements = makeCampaign(deflection::cobraArm(), 10);
  measurements[17].p_W->y() -= 20 * kMeasurementSigma;
  measurements[3].is_held_out = true;
  const auto result = compareCobra(measurements);
  EXPECT_EQ(result.worst.front(), 17);
  EXPECT_EQ(result.worst.size(), measurements.size() - 1);
  const auto& worst = result.measurements[17];
  EXPECT_LT(worst.error_after.y(), -15 * kMeasurementSigma) << "measured less predicted";
  EXPECT_TRUE(result.measurements[3].is_held_out);
  EXPECT_LT(result.measurements[3].sigmas_after, 6);
}

TEST(Comparison, refusesWhatCannotBeFitted) {
  const auto measurements = makeCampaign(deflection::cobraArm(), 10);
  const auto unknown = compareCobra(measurements, {"elbow.joint_stiffness.z"});
  EXPECT_EQ(unknown.status, ComparisonStatus::kRefused);
  EXPECT_EQ(unknown.verdict, Adequacy::kNotRun);
  ASSERT_EQ(unknown.problems.size(), 1u);
  auto all_out = measurements;
  for (auto& measurement : all_out) measurement.is_held_out = true;
  EXPECT_EQ(compareCobra(all_out).status, ComparisonStatus::kRefused);
}

TEST(Repeats, closedFormOfPureErrorAndLackOfFit) {
  // Two measurements of one posture have the errors d and -d, and a measurement of another posture has the error 3 s.
  // The stated standard deviation is s, and the encoders are exact.
  auto arm = deflection::cobraArm();
  for (auto& row : arm.rows) row.joint.encoder_sigma = 0;
  auto measurements = makeCampaign(arm, 1, {2, 1, 0, kMeasurementSigma});
  measurements.insert(measurements.begin(), measurements[0]);
  const double s = kMeasurementSigma, d = 2 * s;
  const auto placed = placeForMeasurements(arm, Isometry3d::Identity(), true, measurements);
  const auto weights = weighMeasurements(placed, measurements);
  VectorXd error(9);
  error << d, 0, 0, -d, 0, 0, 0, 3 * s, 0;
  const double chi2 = error.squaredNorm() / (s * s);
  const auto repeats = judgeRepeats(measurements, *weights, error, chi2, 9);
  EXPECT_EQ(groupRepeats(measurements), (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(repeats.groups, 1);
  EXPECT_EQ(repeats.pure_freedom, 3);
  EXPECT_NEAR(repeats.pure_error, 8, 1e-9);
  EXPECT_NEAR(repeats.noise_ratio, std::sqrt(8. / 3), 1e-9);
  EXPECT_EQ(repeats.lack_freedom, 6);
  EXPECT_NEAR(repeats.lack_of_fit_F, (9. / 6) / (8. / 3), 1e-9);
  // P(chi-square with 3 degrees of freedom > 8) = erfc(2) + 4 exp(-4) / sqrt(pi).
  EXPECT_NEAR(repeats.noise_p_value, 2 * (std::erfc(2.) + 4 * std::exp(-4.) / std::sqrt(EIGEN_PI)), 1e-9);
}

TEST(Repeats, areUnderTheSameLoadsAndBesideTheSameSideChains) {
  auto measurements = makeCampaign(deflection::cobraArm(), 1, {1, 1, 0, kMeasurementSigma});
  measurements.resize(4, measurements[0]);
  for (auto& measurement : measurements) measurement.side_q = Eigen::Vector2d(0.3, -0.2);
  EXPECT_EQ(groupRepeats(measurements), (std::vector<int>{0, 0, 0, 0}));
  measurements[1].wrench = TipWrench{{40, 0, 0}};
  measurements[2].wrench = TipWrench{{0, 40, 0}};
  measurements[3].side_q[1] += 0.5;
  EXPECT_EQ(groupRepeats(measurements), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Repeats, understatedNoiseIsSaidAndDoesNotCondemnTheModel) {
  CampaignPlan plan{18, 4, 2.5 * kMeasurementSigma, kMeasurementSigma};
  const auto result = compareCobra(makeCampaign(deflection::cobraArm(), 12, plan));
  const auto& repeats = result.after_refit.repeats;
  EXPECT_EQ(repeats.groups, 18);
  EXPECT_TRUE(result.noise_disagrees);
  EXPECT_GT(repeats.noise_ratio, 1.5);
  EXPECT_LT(result.after_refit.p_value, 1e-6);
  EXPECT_GT(repeats.lack_of_fit_p_value, 0.01);
  EXPECT_EQ(result.verdict, Adequacy::kAdequate);
}

TEST(Repeats, lackOfFitIsFoundWhereTheStatedNoiseWouldHideIt) {
  CampaignPlan plan{18, 4, kMeasurementSigma, 12 * kMeasurementSigma};
  auto truth = withEffect(deflection::cobraArm(), "joint-offset", "theta2", 0.02 * kDegree);
  const auto result = compareCobra(makeCampaign(truth, 13, plan));
  EXPECT_TRUE(result.noise_disagrees);
  EXPECT_LT(result.after_refit.repeats.noise_ratio, 0.6);
  EXPECT_GT(result.after_refit.p_value, 0.01);
  EXPECT_EQ(result.verdict, Adequacy::kInadequate);
}

TEST(JointEquivalents, correctionsTakeThePredictedTipToTheMeasuredOne) {
  const auto arm = deflection::cobraArm();
  const auto truth = withEffect(arm, "joint-offset", "theta1", 0.1 * kDegree);
  const auto measurements = makeCampaign(truth, 14, {30, 1, 0, kMeasurementSigma});
  const auto placed = placeForMeasurements(arm, Isometry3d::Identity(), true, measurements);
  const auto weights = weighMeasurements(placed, measurements);
  const auto residual = whitenedResidual(placed, {}, measurements, *weights, VectorXd::Zero(0), false);
  const auto joints = equivalentJoints(placed, measurements, residual.error);
  ASSERT_TRUE(joints.ok);
  EXPECT_EQ(joints.degrees_of_freedom, 3 * 30);
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    Measurement corrected = measurements[k];
    corrected.q += joints.corrections.col(static_cast<Eigen::Index>(k));
    const Vector3d remaining = predictMeasurement(arm, Isometry3d::Identity(), corrected).value - *measurements[k].p_W;
    EXPECT_LT(remaining.norm(), 0.02 * residual.error.segment<3>(3 * static_cast<Eigen::Index>(k)).norm());
  }
  // Only joint 1 moves the tip out of the arm's plane; its corrections contain the encoder's noise.
  const double noise = joints.sigma[0];
  EXPECT_NEAR(joints.mean[0], 0.1 * kDegree, 4 * noise / std::sqrt(30.));
  EXPECT_NEAR(joints.spread[0], noise, 0.5 * noise);
  for (int j = 1; j < 4; ++j) EXPECT_LT(std::abs(joints.mean[j]), 0.01 * kDegree);
  EXPECT_LT(joints.p_value, 1e-6);
}

TEST(JointEquivalents, encodersOwnNoiseGivesItsOwnChiSquare) {
  const auto arm = deflection::cobraArm();
  const auto measurements = makeCampaign(arm, 15, {100, 1, 0, kMeasurementSigma});
  const auto placed = placeForMeasurements(arm, Isometry3d::Identity(), true, measurements);
  const auto weights = weighMeasurements(placed, measurements);
  const auto residual = whitenedResidual(placed, {}, measurements, *weights, VectorXd::Zero(0), false);
  const auto joints = equivalentJoints(placed, measurements, residual.error);
  EXPECT_NEAR(joints.chi2 / joints.degrees_of_freedom, 1, 4 * std::sqrt(2. / joints.degrees_of_freedom));
}

}  // namespace
}  // namespace tubeplan::calibration
