// Verdicts on identifiability for confounded parameters, parameters without influence, and redundant geometry.
#include "calibration/estimation/identifiability.hpp"

#include <gtest/gtest.h>

#include <set>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/estimation/whitened_residual.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using enum Identifiability;

struct Seen {
  std::vector<Unknown> unknowns;
  Eigen::MatrixXd jacobian, covariance;
  std::vector<NumberIdentifiability> found;

  [[nodiscard]] std::size_t indexOf(const std::string& name) const {
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (unknowns[k].name == name) return k;
    ADD_FAILURE() << name;
    return 0;
  }
  [[nodiscard]] const NumberIdentifiability& of(const std::string& name) const { return found[indexOf(name)]; }
  [[nodiscard]] double numbers() const { return effectiveNumbers(covariance, unknowns); }
};

Seen see(PlacedArm placed, const std::vector<Measurement>& measurements, const FreeChoice& choice) {
  Seen seen;
  auto unknowns = chooseUnknowns(placed, choice);
  EXPECT_TRUE(unknowns.problems.empty());
  seen.unknowns = unknowns.list;
  const auto weights = weighMeasurements(placed, measurements);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(seen.unknowns.size()));
  seen.jacobian = whitenedResidual(placed, seen.unknowns, measurements, *weights, zero, true).jacobian;
  seen.covariance = posteriorCovariance(seen.jacobian, seen.unknowns);
  seen.found = judgeIdentifiability(seen.jacobian, seen.covariance, seen.unknowns, zero);
  return seen;
}

std::vector<Measurement> positions(const PlacedArm& placed, int count, const std::string& setup = "") {
  MeasurementMaker maker(placed, 11);
  maker.add(MeasurementKind::kPosition, count, setup);
  return maker.measurements;
}

Eigen::MatrixXd inTypicalSizes(const Seen& seen) {
  Eigen::MatrixXd columns = seen.jacobian;
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    columns.col(k) *= seen.unknowns[static_cast<std::size_t>(k)].typical;
  return columns;
}

/// Returns the numerical rank of the Jacobian with respect to the variables divided by their typical sizes.
int rankOf(const Seen& seen) {
  const Eigen::MatrixXd columns = inTypicalSizes(seen);
  const Eigen::VectorXd values = columns.bdcSvd().singularValues();
  return static_cast<int>((values.array() > 1e-8 * values[0]).count());
}

/// Makes the arm rigid and its encoders nearly noise-free, so that every parameter is determined as far as geometry
/// allows.
void makePrecise(PlacedArm& placed) {
  placed.arm = deflection::rigidCopy(placed.arm);
  for (auto& row : placed.arm.rows) row.joint.encoder_sigma = 1e-9;
}

/// Returns an arm with six revolute joints, in which no two successive axes are parallel.
PlacedArm sixAxisArm() {
  PlacedArm placed;
  const double alpha[] = {10, -80, 70, -95, 85, -100}, a[] = {0.05, 0.1, 0.5, 0.08, 0.06, 0.03},
               d[] = {0.4, 0.05, 0.1, 0.5, 0.07, 0.1};
  for (int k = 0; k < 6; ++k) {
    deflection::Row<double> row;
    row.name = "link" + std::to_string(k + 1);
    row.placement = deflection::DenavitHartenberg<double>{alpha[k] * kDegree, a[k], d[k], 0};
    row.joint.name = "J" + std::to_string(k + 1);
    row.joint.type = deflection::JointType::kRevolute;
    row.joint.lower = -170 * kDegree;
    row.joint.upper = 170 * kDegree;
    placed.arm.rows.push_back(row);
  }
  placed.arm.p_LT = {0.05, 0.03, 0.12};
  placed.base_poses = {{"", poseOf({0.3, -0.2, 0.1}, {0.1, 0.2, 0.3}), false}};
  return placed;
}

std::vector<Measurement> preciseMeasurements(const PlacedArm& placed, int count) {
  auto measurements = positions(placed, count);
  for (auto& m : measurements) m.sigma = 1e-6;
  return measurements;
}

TEST(Identifiability, ConfoundedNumbersAreDeterminedInCombinationAndNameEachOther) {
  IdentificationOptions options;
  options.free = {{"latch-link.beam.Iz", "tool.joint_stiffness.z", "latch-link.beam.E"}, false};
  options.folds = 0;
  const auto result = identify(cobra(), positions(cobra(), 12), options);
  ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
  EXPECT_EQ(result.numbers[0].identifiable, kInCombination);
  EXPECT_EQ(result.numbers[0].with, std::vector<std::string>{"latch-link.beam.E"});
  EXPECT_EQ(result.numbers[1].identifiable, kYes);
  EXPECT_EQ(result.numbers[2].identifiable, kInCombination);
  EXPECT_EQ(result.numbers[2].with, std::vector<std::string>{"latch-link.beam.Iz"});
  EXPECT_FALSE(result.numbers[2].note.empty());
}

// Deflections do not depend on the base's position, so its shifts must keep their start values and be reported as not
// identifiable.
TEST(Identifiability, WhatNoMeasurementDependsOnStaysAtItsStartAndSaysSo) {
  PlacedArm placed = cobra();
  placed.base_poses[0].is_known = false;
  MeasurementMaker maker(placed, 2);
  maker.add(MeasurementKind::kDeflection, 10);
  const FreeChoice choice{{"tool.joint_stiffness.z"}, true};
  const Seen seen = see(placed, maker.measurements, choice);
  for (const char* name : {"base.shift.x", "base.shift.y", "base.shift.z"}) {
    EXPECT_EQ(seen.of(name).verdict, kNo) << name;
    EXPECT_TRUE(seen.of(name).with.empty()) << name;
  }
  EXPECT_EQ(seen.of("tool.joint_stiffness.z").verdict, kYes);
  IdentificationOptions options;
  options.free = choice;
  options.folds = 0;
  const auto result = identify(placed, maker.measurements, options);
  EXPECT_EQ(result.numbers[0].identifiable, kNo);
  EXPECT_FALSE(result.numbers[0].note.empty());
  EXPECT_NEAR(result.fitted.base_poses[0].X_WB.translation().x(), placed.base_poses[0].X_WB.translation().x(), 1e-9);
}

// With a free base, `geometry` must free 27 parameters of a six-axis arm (four per axis and three of the tip), all of
// them identifiable.
TEST(Identifiability, GeometryOfASixAxisArmIsDetermined) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  const Seen seen = see(placed, preciseMeasurements(placed, 60), {{"geometry"}, true});
  EXPECT_EQ(seen.unknowns.size(), 27u);
  EXPECT_EQ(rankOf(seen), 27);
  EXPECT_NEAR(seen.numbers(), 27, 0.01);
  for (std::size_t k = 0; k < seen.unknowns.size(); ++k)
    EXPECT_EQ(seen.found[k].verdict, kYes) << seen.unknowns[k].name;
}

TEST(Identifiability, TheTurnOfTheTipIsNamedWhereBothThatMakeItAreFreed) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  const std::set<std::string> in_combination{"link6.joint.offset", "tool.tip.x", "tool.tip.y"};
  std::vector<std::string> free(in_combination.begin(), in_combination.end());
  free.push_back("geometry");
  const Seen seen = see(placed, preciseMeasurements(placed, 60), {free, true});
  EXPECT_EQ(seen.unknowns.size(), 28u);
  EXPECT_EQ(rankOf(seen), 27);
  for (std::size_t k = 0; k < seen.unknowns.size(); ++k)
    EXPECT_EQ(seen.found[k].verdict, in_combination.contains(seen.unknowns[k].name) ? kInCombination : kYes)
        << seen.unknowns[k].name;
}

TEST(Identifiability, ParallelAxesHaveALeanInPlaceOfADistanceAlongThem) {
  PlacedArm placed = cobra();
  placed.base_poses[0].is_known = false;
  makePrecise(placed);
  const Seen seen = see(placed, preciseMeasurements(placed, 60), {{"geometry"}, true});
  EXPECT_EQ(rankOf(seen), 19);  // four per axis for four axes, and three of the tip
  EXPECT_NEAR(seen.numbers(), 19, 0.01);
  for (const char* name : {"forearm.dh.beta", "tool.dh.beta"}) EXPECT_EQ(seen.of(name).verdict, kYes);
}

TEST(Identifiability, BesideAKnownBaseTheFirstAxisIsFound) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  placed.base_poses[0].is_known = true;
  const Seen seen = see(placed, preciseMeasurements(placed, 60), {{"geometry"}, true});
  for (const char* name :
       {"link1.dh.alpha", "link1.dh.a", "link1.dh.d", "link1.dh.beta", "link1.dh.b", "link1.joint.offset"})
    EXPECT_EQ(seen.of(name).verdict, kYes) << name;
  EXPECT_EQ(static_cast<std::size_t>(rankOf(seen)), seen.unknowns.size());
}

TEST(Identifiability, WhatNoiseHidesIsNotIdentifiable) {
  const auto choice = FreeChoice{{"tool.joint_stiffness.z", "latch-link.beam.Iz"}, false};
  auto measurements = positions(cobra(), 12);
  for (const auto& number : see(cobra(), measurements, choice).found) EXPECT_EQ(number.verdict, kYes);
  for (auto& m : measurements) m.sigma = 10 * kInch;
  const Seen blurred = see(cobra(), measurements, choice);
  for (const auto& number : blurred.found) EXPECT_EQ(number.verdict, kNo);
  EXPECT_LT(blurred.numbers(), 1);
}

// The verdict must not change if the fit starts with stiffnesses that are wrong by a large factor.
TEST(Identifiability, AStartFarTooStiffSaysTheSame) {
  auto measurements = positions(cobra(), 12);
  for (const double factor : {1 / 3., 1., 3., 1000.}) {
    PlacedArm off = cobra();
    for (auto& row : off.arm.rows) {
      row.joint_stiffness *= factor;
      if (row.beam) row.beam->I *= factor;
    }
    IdentificationOptions options;
    options.free = {{"tool.joint_stiffness.z", "latch-link.beam.Iz", "mezzanine-platform.joint_stiffness.x",
                     "mezzanine-beam.joint_stiffness.z", "mezzanine-beam.beam.Iz", "forearm.joint_stiffness.z"},
                    false};
    options.folds = 0;
    const auto result = identify(off, measurements, options);
    EXPECT_EQ(result.numbers[0].identifiable, kYes) << factor;
    EXPECT_EQ(result.numbers[1].identifiable, kYes) << factor;
  }
}

/// Whatever the noise, a stiffness that is called identifiable must have a finite interval and a sigma smaller than its
/// value.
TEST(Identifiability, AnIntervalWithoutAnEndIsNotYes) {
  auto measurements = positions(cobra(), 6);
  for (double sigma = 1e-6; sigma < 1; sigma *= 3) {
    for (auto& m : measurements) m.sigma = sigma;
    IdentificationOptions options;
    options.free = {{"forearm.joint_stiffness.z", "tool.joint_stiffness.z"}, false};
    options.folds = 0;
    const auto result = identify(cobra(), measurements, options);
    for (const auto& number : result.numbers) {
      if (number.identifiable != kYes) continue;
      EXPECT_TRUE(std::isfinite(number.lower) && std::isfinite(number.upper)) << number.unknown.name << " " << sigma;
      EXPECT_LT(number.sigma, number.value) << number.unknown.name << " " << sigma;
    }
  }
}

TEST(Identifiability, SingularValuesAreThoseOfTheColumnsInTypicalSizes) {
  IdentificationOptions options;
  options.free = {{"tool.joint_stiffness.z", "latch-link.beam.Iz"}, false};
  options.folds = 0;
  const auto measurements = positions(cobra(), 12);
  const auto result = identify(cobra(), measurements, options);
  ASSERT_EQ(result.singular_values.size(), 2);
  const Seen seen = see(cobra(), measurements, options.free);
  const double squares = inTypicalSizes(seen).squaredNorm();
  EXPECT_NEAR(result.singular_values.squaredNorm(), squares, 1e-3 * squares);
  EXPECT_GE(result.singular_values[0], result.singular_values[1]);
}

/// Neither of two confounded parameters, with prior sigmas of 1 and 10, must be called identifiable: the posterior
/// sigma of the second is 1, but only because of the first one's prior.
TEST(Identifiability, WhatOnlyThePriorOfAConfoundedNumberDeterminesIsNotYes) {
  std::vector<Unknown> unknowns(3);
  for (auto& unknown : unknowns) unknown.typical = unknown.prior_sigma = 10;
  unknowns[0].typical = unknowns[0].prior_sigma = 1;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(4, 3);
  jacobian.col(0).setConstant(1e3);
  jacobian.col(1).setConstant(1e3);
  jacobian(3, 2) = 1e3;
  const auto found =
      judgeIdentifiability(jacobian, posteriorCovariance(jacobian, unknowns), unknowns, Eigen::VectorXd::Zero(3));
  for (const int k : {0, 1}) {
    EXPECT_EQ(found[static_cast<std::size_t>(k)].verdict, kInCombination) << k;
    EXPECT_EQ(found[static_cast<std::size_t>(k)].with, (std::vector<int>{1 - k})) << k;
  }
  EXPECT_EQ(found[2].verdict, kYes);
}

}  // namespace
}  // namespace tubeplan::calibration
