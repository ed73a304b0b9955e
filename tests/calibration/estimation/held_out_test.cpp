// Validation by held-out measurements: measurements at one posture or point must be held out together, and equal seeds
// must give equal folds.
#include "calibration/estimation/held_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns touches of eight points under three loads each, then positions at thirty postures, each of which is repeated
/// twice to within encoder noise.
std::vector<Measurement> campaign(std::uint64_t seed) {
  MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
  maker.addTouches(8, {0, 20 * kPound, 40 * kPound}, false);
  maker.add(MeasurementKind::kPosition, 30);
  for (int repeat = 0; repeat < 2; ++repeat)
    for (std::size_t k = 24; k < 54; ++k) {
      maker.measurements.push_back(maker.measurements[k]);
      for (int j = 0; j < 4; ++j) maker.measurements.back().q[j] += maker.noise(0.002 * kDegree);
    }
  return maker.measurements;
}

TEST(HeldOut, MeasurementsOfOnePointOrPostureGoTogether) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const auto groups = groupByPose(campaign(seed));
    ASSERT_EQ(groups.size(), 24u + 90);
    for (std::size_t k = 0; k < 24; ++k) EXPECT_EQ(groups[k], groups[k - k % 3]);
    for (std::size_t k = 24; k < 54; ++k) {
      EXPECT_EQ(groups[k + 30], groups[k]) << "posture " << k;
      EXPECT_EQ(groups[k + 60], groups[k]) << "posture " << k;
    }
    EXPECT_EQ(std::set<int>(groups.begin(), groups.end()).size(), 38u);
  }
}

TEST(HeldOut, ASlowSweepIsNotOneGroup) {
  std::vector<Measurement> measurements(200);
  for (std::size_t k = 0; k < measurements.size(); ++k)
    measurements[k].q = Eigen::Vector4d(0.3, 1, -1, static_cast<double>(k) * 0.005);
  const auto groups = groupByPose(measurements);
  const auto count = std::set<int>(groups.begin(), groups.end()).size();
  EXPECT_GT(count, 40u);
  EXPECT_LT(count, 120u);
}

TEST(HeldOut, APostureInAnotherSetUpIsAnotherPose) {
  std::vector<Measurement> measurements(2);
  for (auto& m : measurements) m.q = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
  EXPECT_EQ(groupByPose(measurements)[1], 0);
  measurements[1].setup = "B";
  EXPECT_EQ(groupByPose(measurements)[1], 1);
}

TEST(HeldOut, FoldsSplitNoGroupAndAreEven) {
  const auto measurements = campaign(5);
  const auto groups = groupByPose(measurements);
  for (const int folds : {2, 5, 10}) {
    const auto fold = foldsOf(measurements, folds, 7);
    std::vector<std::set<int>> groups_of(static_cast<std::size_t>(folds));
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      ASSERT_GE(fold[k], 0);
      ASSERT_LT(fold[k], folds);
      groups_of[static_cast<std::size_t>(fold[k])].insert(groups[k]);
    }
    std::size_t sum = 0;
    for (const auto& some : groups_of) {
      sum += some.size();
      EXPECT_NEAR(static_cast<double>(some.size()), 38. / folds, 1);
    }
    EXPECT_EQ(sum, 38u) << "a group in two folds";
  }
}

/// Returns positions at different postures: `a` of them in set-up A and `b` in set-up B.
std::vector<Measurement> inTwoSetups(int a, int b) {
  MeasurementMaker maker(cobraTwice(), 15, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, a, "A");
  maker.add(MeasurementKind::kPosition, b, "B");
  return maker.measurements;
}

TEST(HeldOut, ASetUpIsSharedOutEvenlyOrNotKeptOutAtAll) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto even = foldsOf(inTwoSetups(20, 10), 5, seed);
    for (int fold = 0; fold < 5; ++fold) {
      EXPECT_EQ(std::count(even.begin(), even.begin() + 20, fold), 4);
      EXPECT_EQ(std::count(even.begin() + 20, even.end(), fold), 2);
    }
    const auto few = foldsOf(inTwoSetups(20, 4), 5, seed);
    EXPECT_EQ(std::count(few.begin(), few.end(), -1), 4) << "its base would be left to three";
    EXPECT_EQ(std::count(few.begin() + 20, few.end(), -1), 4);
  }
  const auto alone = inTwoSetups(5, 0);
  for (const int fold : foldsOf(alone, 5, 1)) EXPECT_GE(fold, 0) << "there is no other";
}

TEST(HeldOut, IsNotJudgedByItself) {
  PlacedArm placed = cobraTwice();
  auto measurements = inTwoSetups(4, 4);
  const std::vector<Measurement> fitted(measurements.begin(), measurements.begin() + 4),
      of_other(measurements.begin() + 4, measurements.end());
  EXPECT_TRUE(judgeable(placed, fitted, of_other).empty()) << "no reading places B";
  EXPECT_EQ(judgeable(placed, measurements, of_other).size(), 4u);
  placed.base_poses[1].is_known = true;
  EXPECT_EQ(judgeable(placed, fitted, of_other).size(), 4u);
  MeasurementMaker maker(cobra(), 16, MeasurementMaker::Noise::kStated);
  maker.addTouches(3, {0, 20 * kPound}, false);
  EXPECT_EQ(judgeable(cobra(), {}, maker.measurements).size(), 6u) << "two touches of a point tell of each other";
  maker.measurements.pop_back();
  EXPECT_EQ(judgeable(cobra(), {}, maker.measurements).size(), 4u) << "a lone one of nothing";
}

TEST(HeldOut, TheSameSeedDrawsTheSameFolds) {
  const auto measurements = campaign(6);
  EXPECT_EQ(foldsOf(measurements, 5, 3), foldsOf(measurements, 5, 3));
  EXPECT_NE(foldsOf(measurements, 5, 3), foldsOf(measurements, 5, 4));
}

TEST(HeldOut, FewerGroupsThanFoldsMakeFewerFolds) {
  std::vector<Measurement> measurements(4);
  for (std::size_t k = 0; k < 4; ++k) measurements[k].q = Eigen::Vector4d(static_cast<double>(k / 2), 0, 0, 0);
  const auto fold = foldsOf(measurements, 5, 1);
  EXPECT_EQ(fold[0], fold[1]);
  EXPECT_EQ(std::set<int>(fold.begin(), fold.end()).size(), 2u);
  EXPECT_TRUE(foldsOf({}, 5, 1).empty());
}

TEST(HeldOut, JudgesByTheErrorsOfTheTruth) {
  MeasurementMaker maker(cobra(), 9);
  maker.add(MeasurementKind::kPosition, 6);
  EXPECT_LE(judge(cobra(), maker.measurements).max, 1e-8);
  for (auto& m : maker.measurements) *m.p_W += Eigen::Vector3d(3e-3, 0, -4e-3);
  const ErrorSize size = judge(cobra(), maker.measurements);
  EXPECT_EQ(size.measurements, 6);
  for (const double figure : {size.rms, size.mean, size.max}) EXPECT_NEAR(figure, 5e-3, 1e-8);
  EXPECT_EQ(judge(cobra(), {}).measurements, 0);
}

// Cross-validation must predict every measurement once, by a fit to the measurements of the other folds. Its error must
// exceed that of a fit to all measurements.
TEST(HeldOut, CrossValidationJudgesEveryMeasurementOnceByAFitWithoutIt) {
  PlacedArm placed = cobra();
  MeasurementMaker maker(placed, 12, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 12);
  const auto unknowns = chooseUnknowns(placed, {{"tool.tip"}, false}).list;
  const auto folds = foldsOf(maker.measurements, 4, 1);
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
  const ErrorSize cross = crossValidate(placed, unknowns, maker.measurements, x, folds, {});
  double squares = 0;
  for (int fold = 0; fold < 4; ++fold) {
    std::vector<Measurement> kept, out;
    for (std::size_t k = 0; k < 12; ++k) (folds[k] == fold ? out : kept).push_back(maker.measurements[k]);
    const Fit fit = fitUnknowns(placed, unknowns, kept, x, {});
    const ErrorSize part = judge(applied(placed, unknowns, fit.solution.x), out);
    squares += part.rms * part.rms * part.measurements;
  }
  EXPECT_EQ(cross.measurements, 12);
  EXPECT_NEAR(cross.rms, std::sqrt(squares / 12), 1e-9);
  const Fit all = fitUnknowns(placed, unknowns, maker.measurements, x, {});
  EXPECT_GT(cross.rms, judge(applied(placed, unknowns, all.solution.x), maker.measurements).rms);
}

// Expects that, for many measurements, cross-validation by single steps gives the same error as by separate fits, and
// that it is refused if a fold's fit is many sigmas away from the fit to all measurements.
void expectStepsLikeFits(bool with_touches) {
  SCOPED_TRACE(with_touches ? "with touched points, whose places each fold estimates" : "errors to first order");
  PlacedArm placed = cobra();
  MeasurementMaker maker(placed, 12, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 300);
  if (with_touches) maker.addTouches(20, {0, 20 * kPound}, false);
  const auto unknowns = chooseUnknowns(placed, {{"tool.tip", "forearm.joint_stiffness.z"}, false}).list;
  const auto folds = foldsOf(maker.measurements, 5, 1);
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  const Fit all = fitUnknowns(placed, unknowns, maker.measurements, Eigen::VectorXd::Zero(count), {});
  FitOptions options;
  options.model_error = all.weights.model_error;
  const ErrorSize by_fits = crossValidate(placed, unknowns, maker.measurements, all.solution.x, folds, options);
  const auto by_steps = crossValidateBySteps(placed, unknowns, maker.measurements, all, folds);
  ASSERT_TRUE(by_steps);
  EXPECT_EQ(by_steps->measurements, by_fits.measurements);
  const double rise = by_fits.rms - judge(applied(placed, unknowns, all.solution.x), maker.measurements).rms;
  EXPECT_GT(rise, 0);
  EXPECT_NEAR(by_steps->rms, by_fits.rms, 0.01 * rise);
  for (std::size_t k = 0; k < maker.measurements.size(); ++k)
    if (folds[k] == 0 && maker.measurements[k].p_W) *maker.measurements[k].p_W += Eigen::Vector3d(0.05, 0, 0);
  const Fit torn = fitUnknowns(placed, unknowns, maker.measurements, Eigen::VectorXd::Zero(count), {});
  Fit confident = torn;
  confident.covariance *= 1e-6;
  EXPECT_FALSE(crossValidateBySteps(placed, unknowns, maker.measurements, confident, folds));
}

TEST(HeldOut, CrossValidationByStepsIsThatByFits) {
  expectStepsLikeFits(true);
  expectStepsLikeFits(false);
}

}  // namespace
}  // namespace tubeplan::calibration
