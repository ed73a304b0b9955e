// Identification must recover the parameters of a known arm from measurements: exactly without noise, and reliably in
// spite of gross errors.
#include "calibration/estimation/identification.hpp"

#include <gtest/gtest.h>

#include <set>

#include "calibration/estimation/held_out.hpp"
#include "tests/calibration/estimation/freeing.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Noise = MeasurementMaker::Noise;

double& stiffnessOf(deflection::Arm& arm, const std::string& name) {
  return deflection::locate(arm, deflection::findParameter(arm, name)->path);
}

const std::vector<std::string> kSoft{"tool.joint_stiffness.z", "latch-link.beam.Iz",
                                     "mezzanine-platform.joint_stiffness.x"};

/// Multiplies the k-th named stiffness by 3 if bit k of `ways` is set, otherwise by 1/3.
PlacedArm offByThree(PlacedArm placed, const std::vector<std::string>& names, unsigned ways) {
  for (std::size_t k = 0; k < names.size(); ++k) stiffnessOf(placed.arm, names[k]) *= ways >> k & 1U ? 3 : 1 / 3.;
  return placed;
}

void expectFound(const Identification& result, const PlacedArm& truth, double relative) {
  ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
  for (const auto& number : result.numbers) {
    if (number.unknown.owner == Unknown::Owner::kBase) continue;
    const double value = deflection::findParameter(truth.arm, number.unknown.name)->value;
    EXPECT_NEAR(number.value, value, relative * std::max(std::abs(value), number.unknown.typical))
        << number.unknown.name;
  }
  for (std::size_t p = 0; p < truth.base_poses.size(); ++p)
    EXPECT_LE((result.fitted.base_poses[p].X_WB.matrix() - truth.base_poses[p].X_WB.matrix()).norm(), relative) << p;
}

TEST(Identification, FindsTheTruthFromEveryKindOfMeasurement) {
  const struct {
    MeasurementKind kind;
    int count;
  } kKinds[] = {{MeasurementKind::kPosition, 8},
                {MeasurementKind::kDeflection, 10},
                {MeasurementKind::kDistance, 20},
                {MeasurementKind::kAxis, 20}};
  const PlacedArm truth = cobra();
  unsigned ways = 2;
  for (const auto& [kind, count] : kKinds) {
    MeasurementMaker maker(truth, 21);
    maker.add(kind, count);
    SCOPED_TRACE(static_cast<int>(kind));
    expectFound(identify(offByThree(truth, kSoft, ways++), maker.measurements, freeingBlindly(kSoft)), truth, 1e-6);
  }
  for (const bool known : {false, true}) {
    MeasurementMaker maker(truth, 22);
    maker.addTouches(8, {0, 20 * kPound, 40 * kPound}, known);
    SCOPED_TRACE(known ? "known points" : "unknown points");
    expectFound(identify(offByThree(truth, kSoft, ways++), maker.measurements, freeingBlindly(kSoft)), truth, 1e-6);
  }
}

TEST(Identification, FindsTheTruthFromAMixOfKindsAtTwoSetUpsFromAnyFactorOfThree) {
  const PlacedArm truth = cobraTwice();
  MeasurementMaker maker(truth, 23);
  addEveryKind(maker, 4, "A");
  maker.add(MeasurementKind::kPosition, 6, "B");
  maker.add(MeasurementKind::kDeflection, 4, "B");
  auto names = kSoft;
  names.insert(names.end(), {"forearm.dh.a", "forearm.joint.offset"});
  for (const unsigned ways : {0U, 3U, 5U, 7U}) {
    PlacedArm start = offByThree(truth, kSoft, ways);
    for (auto& base_pose : start.base_poses) base_pose.X_WB = poseOf({0.3, 0, 0}, {0, 0, 0});
    stiffnessOf(start.arm, "forearm.dh.a") += 0.004;
    stiffnessOf(start.arm, "forearm.joint.offset") -= 0.01;
    SCOPED_TRACE(ways);
    const auto result = identify(start, maker.measurements, freeingBlindly(names));
    expectFound(result, truth, 1e-6);
    EXPECT_LT(result.chi2, 1e-6);
    EXPECT_LT(result.after.max, 1e-8);
    EXPECT_GT(result.before.rms, 0.1);
  }
}

TEST(Identification, AnAxisTakenAsRigidIsFoundToGive) {
  PlacedArm truth = cobra();
  truth.arm.rows[2].joint_stiffness.y() = 40000;
  MeasurementMaker maker(truth, 24);
  maker.add(MeasurementKind::kPosition, 8);
  const auto result = identify(cobra(), maker.measurements, freeingBlindly({"base-link.joint_stiffness.y"}));
  expectFound(result, truth, 1e-6);
}

TEST(Identification, TheNumbersOfANoisyFitAreWithinTheirIntervals) {
  // The probability that more than two of twelve 95 % intervals miss the true value is below 0.02.
  int outside = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    MeasurementMaker maker(cobra(), seed, Noise::kStated);
    addEveryKind(maker, 3);
    const auto result = identify(cobra(), maker.measurements, freeing(kSoft));
    EXPECT_GT(result.p_value, 1e-3);
    EXPECT_EQ(result.degrees_of_freedom, 3 * 3 + 3 * 3 + 3 + 3 * 6 + 3 * 9 - 9 - 3);
    for (const auto& number : result.numbers) {
      EXPECT_LT(number.lower, number.value);
      outside += number.unknown.start < number.lower || number.unknown.start > number.upper;
    }
  }
  EXPECT_LE(outside, 2);
}

TEST(Identification, TheSameSeedGivesTheSameNumbers) {
  MeasurementMaker maker(cobra(), 25, Noise::kStated);
  maker.add(MeasurementKind::kPosition, 8);
  auto options = freeing(kSoft);
  options.starts = 3;
  options.folds = 3;
  const auto one = identify(cobra(), maker.measurements, options), two = identify(cobra(), maker.measurements, options);
  for (std::size_t k = 0; k < one.numbers.size(); ++k) EXPECT_EQ(one.numbers[k].value, two.numbers[k].value);
  EXPECT_EQ(one.heldout.rms, two.heldout.rms);
  EXPECT_EQ(one.starts_agreeing, 3);
}

TEST(Identification, HeldOutMeasurementsAreJudgedButNotFitted) {
  MeasurementMaker maker(cobra(), 26);
  maker.add(MeasurementKind::kPosition, 10);
  for (std::size_t k = 8; k < 10; ++k) {
    maker.measurements[k].is_held_out = true;
    *maker.measurements[k].p_W += Eigen::Vector3d(0, 0.02, 0);
  }
  const auto result = identify(cobra(), maker.measurements, freeing(kSoft));
  EXPECT_LT(result.after.max, 1e-8);
  EXPECT_EQ(result.heldout.measurements, 2);
  EXPECT_NEAR(result.heldout.mean, 0.02, 1e-7);
  EXPECT_EQ(result.used.size(), 8u);
}

TEST(Identification, RefusesWithAReason) {
  MeasurementMaker maker(cobra(), 27);
  maker.add(MeasurementKind::kPosition, 3);
  EXPECT_EQ(identify(cobra(), maker.measurements, freeing({})).status, IdentificationStatus::kRefused);
  const auto unknown = identify(cobra(), maker.measurements, freeing({"tool.jiont_stiffness.z"}));
  EXPECT_EQ(unknown.status, IdentificationStatus::kRefused);
  ASSERT_EQ(unknown.problems.size(), 1u);
  const auto empty = identify(cobra(), {}, freeing(kSoft));
  EXPECT_EQ(empty.status, IdentificationStatus::kRefused);
  EXPECT_FALSE(empty.reason.empty());
  MeasurementMaker single_touch(cobra(), 28);
  single_touch.add(MeasurementKind::kPosition, 2);
  single_touch.addTouches(1, {0}, false);
  single_touch.measurements[0].is_held_out = true;
  const auto once = identify(cobra(), single_touch.measurements, freeing(kSoft));
  ASSERT_TRUE(once.measurement_problem);
  EXPECT_EQ(once.measurement_problem->measurement, 2) << "as it was given, held-out readings counted";
}

/// Returns the Cobra arm as a rigid arm, which is faster to evaluate; the treatment of outliers does not depend on
/// flexibility.
PlacedArm rigidCobra() {
  PlacedArm placed = cobra();
  placed.arm = deflection::rigidCopy(placed.arm);
  placed.base_poses[0].is_known = false;
  return placed;
}

const std::vector<std::string> kOffsets{"latch-link.joint.offset", "forearm.joint.offset", "tool.joint.offset"};

/// Returns the measurements with gross errors of length `size` [m] added to those with the indices `which`, in three
/// alternating directions.
std::vector<Measurement> withGrossErrors(std::vector<Measurement> measurements, const std::vector<std::size_t>& which,
                                         double size) {
  const Eigen::Vector3d ways[] = {{1, 0, 0}, {0, 0.6, -0.8}, {-0.6, 0.8, 0}};
  for (std::size_t k = 0; k < which.size(); ++k) *measurements[which[k]].p_W += size * ways[k % 3];
  return measurements;
}

TEST(Outliers, PlantedOnesAreNamedWithTheirSize) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MeasurementMaker maker(rigidCobra(), seed, Noise::kStated);
    maker.add(MeasurementKind::kPosition, 40);
    const auto measurements = withGrossErrors(maker.measurements, {4, 23}, 0.1 * kInch);
    for (const auto loss : {RobustLoss::kNone, RobustLoss::kHuber, RobustLoss::kCauchy}) {
      auto options = freeing(kOffsets);
      options.loss = loss;
      const auto result = identify(rigidCobra(), measurements, options);
      ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
      std::set<int> named;
      for (const auto& outlier : result.outliers) {
        named.insert(outlier.measurement);
        // The reported size also includes the measurement's own noise of a few thousandths of an inch.
        EXPECT_NEAR(outlier.size, 0.1 * kInch, 0.025 * kInch) << seed << " loss " << static_cast<int>(loss);
      }
      EXPECT_EQ(named, (std::set<int>{4, 23})) << seed << " loss " << static_cast<int>(loss);
    }
  }
}

TEST(Outliers, CleanMeasurementsHaveNone) {
  PlacedArm placed = rigidCobra();
  placed.base_poses[0].is_known = true;
  int clean = 0;
  constexpr int kSeeds = 100;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    MeasurementMaker maker(placed, seed, Noise::kStated);
    maker.add(MeasurementKind::kPosition, 12);
    maker.add(MeasurementKind::kDistance, 6);
    clean += identify(placed, maker.measurements, freeing(kOffsets)).outliers.empty();
  }
  EXPECT_GE(clean, 95);
}

// If the stated noise is too small by a factor of eight everywhere, all measurements fit equally badly, and none may be
// reported as an outlier.
TEST(Outliers, AMisfitEverywhereIsNoOutlier) {
  PlacedArm start = rigidCobra();
  for (auto& row : start.arm.rows) row.joint.encoder_sigma /= 8;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    MeasurementMaker maker(rigidCobra(), seed, Noise::kStated);
    maker.add(MeasurementKind::kPosition, 30);
    for (auto& m : maker.measurements) m.sigma /= 8;
    const auto result = identify(start, maker.measurements, freeing(kOffsets));
    EXPECT_TRUE(result.outliers.empty()) << seed;
    // The model error must make up the difference between the true and the stated variance: (8^2 - 1) sigma^2.
    EXPECT_NEAR(result.model_error / maker.measurements.front().sigma, 8 * std::sqrt(63) / 8, 2) << seed;
  }
}

// If a robust loss reduces the weights of some touches of unknown points, the reported errors must still be relative to
// points estimated without the loss, as judge() estimates them.
TEST(RobustLoss, ReportsTheErrorThatTheFittedArmHas) {
  MeasurementMaker maker(cobra(), 5, Noise::kStated);
  maker.addTouches(15, {0, 30 * kPound}, false);
  for (std::size_t k = 0; k < maker.measurements.size(); k += 7) maker.measurements[k].q[1] += 0.2 * kDegree;
  IdentificationOptions options = freeing(kSoft);
  options.loss = RobustLoss::kCauchy;
  const auto result = identify(cobra(), maker.measurements, options);
  ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
  EXPECT_NEAR(judge(result.fitted, maker.measurements).rms, result.after.rms, 1e-3 * result.after.rms);
}

// With either robust loss, the mean of chi-square per degree of freedom must stay near 1, although the loss reduces the
// weights of good measurements slightly.
TEST(RobustLoss, LeavesTheLackOfFitComparableWithItsFreedom) {
  for (const auto loss : {RobustLoss::kHuber, RobustLoss::kCauchy}) {
    double each = 0;
    constexpr int kSeeds = 12;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      MeasurementMaker maker(rigidCobra(), seed, Noise::kStated);
      maker.add(MeasurementKind::kPosition, 60);
      auto options = freeing(kOffsets);
      options.loss = loss;
      const auto result = identify(rigidCobra(), maker.measurements, options);
      each += result.chi2 / result.degrees_of_freedom / kSeeds;
    }
    EXPECT_NEAR(each, 1, 0.06) << static_cast<int>(loss);
  }
}

TEST(Stages, ANumberThatIsFreedAgainIsNotHeldBesideItself) {
  MeasurementMaker maker(cobra(), 8, Noise::kStated);
  maker.add(MeasurementKind::kPosition, 60);
  const IdentificationStage stage{{"tool.joint_stiffness.z"}, ""};
  const auto once = identifyInStages(cobra(), maker.measurements, {stage}, freeing({}));
  const auto twice = identifyInStages(cobra(), maker.measurements, {stage, stage}, freeing({}));
  EXPECT_NEAR(twice.back().numbers.front().sigma, once.back().numbers.front().sigma,
              1e-3 * once.back().numbers.front().sigma);
}

TEST(RobustLoss, HoldsAgainstGrossErrorsInOneMeasurementOfTwenty) {
  double worst_plain = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PlacedArm truth = rigidCobra();
    MeasurementMaker maker(truth, seed, Noise::kStated);
    maker.add(MeasurementKind::kPosition, 40);
    const auto measurements = withGrossErrors(maker.measurements, {7, 31}, 1.0625 * kInch);
    for (const auto loss : {RobustLoss::kNone, RobustLoss::kHuber, RobustLoss::kCauchy}) {
      auto options = freeing(kOffsets);
      options.loss = loss;
      const auto clean = identify(truth, maker.measurements, freeing(kOffsets));
      const auto result = identify(truth, measurements, options);
      ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
      double worst = 0;
      for (std::size_t k = 6; k < 9; ++k)
        worst = std::max(worst,
                         std::abs(result.numbers[k].value - result.numbers[k].unknown.start) / clean.numbers[k].sigma);
      if (loss == RobustLoss::kNone)
        worst_plain = std::max(worst_plain, worst);
      else
        EXPECT_LT(worst, 5) << seed << " loss " << static_cast<int>(loss);
    }
  }
  EXPECT_GT(worst_plain, 20) << "the gross errors do no harm: nothing is shown";
}

}  // namespace
}  // namespace tubeplan::calibration
