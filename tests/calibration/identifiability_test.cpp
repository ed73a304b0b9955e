// What readings can tell: exact twins, numbers nobody sees, the redundancies of geometry, and who is kept.
#include "calibration/identifiability.hpp"

#include <gtest/gtest.h>

#include "calibration/identification.hpp"
#include "calibration/whitened_residual.hpp"
#include "tests/calibration/synthetic_readings.hpp"

namespace tubeplan::calibration {
namespace {

using Told = calibration::Told;

struct Seen {
  std::vector<Unknown> unknowns;
  Eigen::MatrixXd jacobian;
  Identifiability found;

  [[nodiscard]] int indexOf(const std::string& name) const {
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (unknowns[k].name == name) return static_cast<int>(k);
    ADD_FAILURE() << name;
    return 0;
  }
  [[nodiscard]] bool keeps(const std::string& name) const {
    return std::find(found.kept.begin(), found.kept.end(), indexOf(name)) != found.kept.end();
  }
  [[nodiscard]] const HeldUnknown& held(const std::string& name) const {
    for (const auto& held : found.held)
      if (held.unknown == indexOf(name)) return held;
    static const HeldUnknown kNone;
    ADD_FAILURE() << name << " is not held";
    return kNone;
  }
};

Seen see(PlacedArm placed, const std::vector<Measurement>& readings, const FreeChoice& choice) {
  Seen seen;
  auto unknowns = chooseUnknowns(placed, choice);
  EXPECT_TRUE(unknowns.problems.empty());
  seen.unknowns = unknowns.list;
  const auto weights = weighReadings(placed, readings);
  const auto n = static_cast<Eigen::Index>(seen.unknowns.size());
  seen.jacobian = whitenedResidual(placed, seen.unknowns, readings, *weights, Eigen::VectorXd::Zero(n), true).jacobian;
  seen.found = findIdentifiable(seen.jacobian, seen.unknowns);
  return seen;
}

std::vector<Measurement> positions(const PlacedArm& placed, int count, const std::string& setup = "") {
  ReadingMaker maker(placed, 11);
  maker.add(MeasurementKind::kPosition, count, setup);
  return maker.readings;
}

Eigen::MatrixXd inTypicalSizes(const Seen& seen) {
  Eigen::MatrixXd columns = seen.jacobian;
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    columns.col(k) *= seen.unknowns[static_cast<std::size_t>(k)].typical;
  return columns;
}

/// Rank by singular values, columns over their typical sizes.
int rankOf(const Seen& seen) {
  const Eigen::MatrixXd columns = inTypicalSizes(seen);
  const Eigen::VectorXd values = columns.bdcSvd().singularValues();
  return static_cast<int>((values.array() > 1e-8 * values[0]).count());
}

/// Exact readings of an arm without flexibility, whose noise hides nothing.
void makePrecise(PlacedArm& placed) {
  placed.arm = deflection::rigidCopy(placed.arm);
  for (auto& row : placed.arm.rows) row.joint.encoder_sigma = 1e-9;
}

/// Six revolute axes, no two neighbours parallel.
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
  placed.placings = {{"", poseOf({0.3, -0.2, 0.1}, {0.1, 0.2, 0.3}), false}};
  return placed;
}

std::vector<Measurement> preciseReadings(const PlacedArm& placed, int count) {
  auto readings = positions(placed, count);
  for (auto& m : readings) m.sigma = 1e-6;
  return readings;
}

TEST(Identifiability, OfExactTwinsTheFirstIsKeptAndTheOtherSaysWithWhom) {
  const auto readings = positions(cobra(), 12);
  const std::string E = "latch-link.beam.E", I = "latch-link.beam.Iz", other = "tool.joint_stiffness.z";
  for (const bool swapped : {false, true}) {
    const std::string &first = swapped ? I : E, &second = swapped ? E : I;
    const Seen seen = see(cobra(), readings, {{first, other, second}, false});
    EXPECT_TRUE(seen.keeps(first));
    EXPECT_TRUE(seen.keeps(other));
    const HeldUnknown& held = seen.held(second);
    EXPECT_TRUE(held.is_seen);
    ASSERT_EQ(held.with, std::vector<int>{seen.indexOf(first)});
    EXPECT_NEAR(held.shares[0], 1, 1e-9);
  }
}

TEST(Identifiability, TwinsAreNamedBothWaysInTheAnswer) {
  IdentificationOptions options;
  options.free = {{"latch-link.beam.Iz", "tool.joint_stiffness.z", "latch-link.beam.E"}, false};
  options.folds = 0;
  const auto result = identify(cobra(), positions(cobra(), 12), options);
  ASSERT_EQ(result.status, IdentificationStatus::kDone) << result.reason;
  EXPECT_EQ(result.numbers[0].told, Told::kWith);
  EXPECT_EQ(result.numbers[0].with, std::vector<std::string>{"latch-link.beam.E"});
  EXPECT_EQ(result.numbers[1].told, Told::kYes);
  EXPECT_EQ(result.numbers[2].told, Told::kWith);
  EXPECT_EQ(result.numbers[2].with, std::vector<std::string>{"latch-link.beam.Iz"});
  EXPECT_TRUE(result.numbers[2].is_held);
  EXPECT_FALSE(result.numbers[0].is_held);
  EXPECT_DOUBLE_EQ(result.numbers[2].value, result.numbers[2].unknown.start);
}

// A deflection does not say where the base stands, nor which way it faces; that it leans shows in what hangs down.
TEST(Identifiability, WhatNoReadingDependsOnIsNotTold) {
  PlacedArm placed = cobra();
  placed.placings[0].is_known = false;
  ReadingMaker maker(placed, 2);
  maker.add(MeasurementKind::kDeflection, 10);
  const Seen seen = see(placed, maker.readings, {{"tool.joint_stiffness.z"}, true});
  for (const char* name : {"base.shift.x", "base.shift.y", "base.shift.z"}) {
    EXPECT_FALSE(seen.held(name).is_seen) << name;
    EXPECT_TRUE(seen.held(name).with.empty()) << name;
  }
  EXPECT_TRUE(seen.keeps("tool.joint_stiffness.z"));
  IdentificationOptions options;
  options.free = {{"tool.joint_stiffness.z"}, true};
  options.folds = 0;
  const auto result = identify(placed, maker.readings, options);
  EXPECT_EQ(result.numbers[0].told, Told::kNo);
  EXPECT_FALSE(result.numbers[0].note.empty());
}

// Six axes need 4 x 6 numbers between them, six for the base and three for the tip, less the six that the first and
// last frame share with those: 27 of 33.
TEST(Identifiability, GeometryOfASixAxisArmIsToldUpToItsRedundancies) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  const Seen seen = see(placed, preciseReadings(placed, 60), {{"geometry"}, true});
  EXPECT_EQ(seen.unknowns.size(), 33u);
  EXPECT_EQ(rankOf(seen), 27);
  EXPECT_EQ(seen.found.kept.size(), 27u);
  EXPECT_EQ(seen.found.held.size(), 6u);
  for (const char* name : {"link1.dh.alpha", "link1.dh.a", "link1.dh.d", "link1.joint.offset"})
    EXPECT_TRUE(seen.held(name).is_seen) << name;
  for (const auto& held : seen.found.held) EXPECT_FALSE(held.with.empty());
}

TEST(Identifiability, AlongParallelAxesOneLengthIsTold) {
  PlacedArm placed = cobra();
  placed.placings[0].is_known = false;
  makePrecise(placed);
  const Seen seen = see(placed, preciseReadings(placed, 60), {{"geometry"}, true});
  EXPECT_EQ(rankOf(seen), 17);  // four axes: 4 x 4 + 3, less one for each axis parallel to the one before
  EXPECT_EQ(seen.found.kept.size(), 17u);
  int lengths = 0;
  for (const char* name : {"latch-link.dh.d", "forearm.dh.d", "tool.dh.d", "tool.tip.z"}) lengths += seen.keeps(name);
  EXPECT_EQ(lengths, 1);
}

TEST(Identifiability, AKnownBaseSparesItsSixNumbers) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  placed.placings[0].is_known = true;
  const Seen seen = see(placed, preciseReadings(placed, 60), {{"geometry"}, true});
  EXPECT_EQ(seen.unknowns.size(), 27u);
  EXPECT_EQ(rankOf(seen), static_cast<int>(seen.found.kept.size()));
  EXPECT_EQ(seen.found.kept.size(), 25u);  // the first frame's four are told now; the last one's two still are not
}

TEST(Identifiability, PlacingsComeBeforeNamedNumbersAndThoseBeforeGeometry) {
  PlacedArm placed = sixAxisArm();
  makePrecise(placed);
  const auto readings = preciseReadings(placed, 60);
  const Seen named = see(placed, readings, {{"link1.dh.d", "link6.dh.d", "geometry"}, true});
  for (const char* name : {"base.shift.x", "base.shift.y", "base.shift.z", "base.turn.x", "base.turn.y", "base.turn.z"})
    EXPECT_TRUE(named.keeps(name)) << name;
  EXPECT_FALSE(named.keeps("link1.dh.d"));
  EXPECT_TRUE(named.keeps("link6.dh.d"));
  EXPECT_FALSE(named.keeps("tool.tip.z"));
  const Seen tip = see(placed, readings, {{"tool.tip", "geometry"}, true});
  EXPECT_TRUE(tip.keeps("tool.tip.z"));
  EXPECT_FALSE(tip.keeps("link6.dh.d"));
  EXPECT_EQ(named.found.kept.size(), 27u);
  EXPECT_EQ(tip.found.kept.size(), 27u);
}

TEST(Identifiability, WhatNoiseHidesIsNotTold) {
  const auto choice = FreeChoice{{"tool.joint_stiffness.z", "forearm.joint_stiffness.z"}, false};
  auto readings = positions(cobra(), 12);
  EXPECT_EQ(see(cobra(), readings, choice).found.kept.size(), 2u);
  for (auto& m : readings) m.sigma = 10 * kInch;
  const Seen blurred = see(cobra(), readings, choice);
  EXPECT_TRUE(blurred.found.kept.empty());
}

// What is told must not hang on a start that may be off by a factor.
TEST(Identifiability, AStartFarTooStiffTellsTheSame) {
  auto readings = positions(cobra(), 12);
  for (const double factor : {1 / 3., 1., 3., 1000.}) {
    PlacedArm off = cobra();
    for (auto& row : off.arm.rows) row.joint_stiffness *= factor;
    const Seen seen = see(off, readings, {{"tool.joint_stiffness.z", "forearm.joint_stiffness.z"}, false});
    EXPECT_EQ(seen.found.kept.size(), 2u) << factor;
  }
}

// What stands at its bound takes nothing from what can move.
TEST(Identifiability, OfTwinsTheOneAtItsBoundIsHeld) {
  PlacedArm placed = cobra();
  const auto readings = positions(placed, 12);
  Seen seen = see(placed, readings, {{"tool.tip.x", "geometry"}, true});
  const int first = seen.found.kept.front();
  IdentifiabilityOptions options;
  Eigen::MatrixXd twice(seen.jacobian.rows(), 2);
  twice << seen.jacobian.col(first), 2 * seen.jacobian.col(first);
  const std::vector<Unknown> unknowns{seen.unknowns[static_cast<std::size_t>(first)],
                                      seen.unknowns[static_cast<std::size_t>(first)]};
  EXPECT_EQ(findIdentifiable(twice, unknowns, options).kept, std::vector<int>{0});
  options.at_bound = {0};
  EXPECT_EQ(findIdentifiable(twice, unknowns, options).kept, std::vector<int>{1});
  options.twins_stay = true;
  EXPECT_EQ(findIdentifiable(twice, unknowns, options).kept, (std::vector<int>{0, 1}));
}

TEST(Identifiability, SingularValuesAreThoseOfTheKeptColumns) {
  const Seen seen = see(cobra(), positions(cobra(), 12), {{"tool.joint_stiffness.z", "latch-link.beam.Iz"}, false});
  ASSERT_EQ(seen.found.singular_values.size(), 2);
  const double squares = inTypicalSizes(seen).squaredNorm();
  EXPECT_NEAR(seen.found.singular_values.squaredNorm(), squares, 1e-9 * squares);
  EXPECT_GE(seen.found.singular_values[0], seen.found.singular_values[1]);
}

}  // namespace
}  // namespace tubeplan::calibration
