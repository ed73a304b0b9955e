// Common mistakes in measurements are named, no mistake is reported in clean measurements, and each proposal corrects
// its mistake. studies/measurement_checks.cpp runs the same judgement on many more sets.
#include "calibration/measurement_checks/measurement_checks.hpp"

#include <gtest/gtest.h>

#include "app/formats/measurements/assumptions.hpp"
#include "calibration/measurement_checks/copies.hpp"
#include "calibration/measurement_checks/shifted_rows.hpp"
#include "calibration/patterns/comparison.hpp"
#include "deflection/row_conventions.hpp"
#include "tests/calibration/measurement_checks/seeded_pairs.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

class EachMistake : public ::testing::TestWithParam<std::size_t> {};

// Each mistake is named in at least two of three sets; in the third, the priors may explain the error. The zero of the
// last joint is excluded: for tip positions it is equivalent to a tool mounted elsewhere.
TEST_P(EachMistake, IsNamed) {
  constexpr int kSets = 3;
  const auto& kind = seededMistakes().at(GetParam());
  SeededRandom random(17);
  int made = 0, named = 0;
  std::string found;
  for (std::uint64_t number = 0; number < 120 && made < kSets; ++number) {
    auto set = cleanSet(number);
    const auto correction = set ? kind.make(*set, random) : std::nullopt;
    if (!correction || *correction == "joint-zero=theta4") continue;
    ++made;
    const auto checks = checksOf(*set);
    const Naming naming = judgeNaming(kind, *correction, checks);
    named += naming == Naming::kRight || naming == Naming::kEqually;
    found += fmt::format("{} in {}: found {}\n", *correction, set->name,
                         checks.checks.empty() ? "nothing" : checks.checks.front().sentence);
  }
  ASSERT_EQ(made, kSets) << "too few sets have room for " << kind.label;
  EXPECT_GE(named, kSets - 1) << found;
}

/// Returns chi-square per degree of freedom of a correct model for measurements corrected as a check proposes. A zero
/// or scale found with the drawing's stiffnesses leaves a residual error, so the model frees these parameters.
double chi2Corrected(SeededSet& set, const std::string& assume) {
  (void)app::takeAssumptions({assume}, set.table, set.cell);
  ComparisonOptions options;
  options.refit.free = app::freeNumbersOf(set.cell);
  options.refit.folds = 0;
  if (assume.starts_with("joint-zero=") && assume.find('@') == std::string::npos)
    for (const int row : deflection::activeRows(set.cell.arm))
      options.refit.free.names.push_back(set.cell.arm.rows[static_cast<std::size_t>(row)].name + ".joint.offset");
  if (assume.starts_with("joint-scale=")) {
    const std::string joint = assume.substr(assume.find('=') + 1, assume.find(':') - assume.find('=') - 1);
    set.cell.arm.effects.push_back(deflection::makeEffect(set.cell.arm, "joint-scale", joint).effect);
    options.refit.free.names.push_back("joint-scale@" + joint + ".scale");
  }
  const auto comparison = compare(app::startOf(set.cell, set.table.measurements), set.table.measurements, options);
  return comparison.after_refit.chi2 / comparison.after_refit.degrees_of_freedom;
}

// After the proposed correction, chi-square is as expected of the noise. If the sigmas stayed in the wrong unit, it
// would be off by a factor of hundreds.
TEST_P(EachMistake, IsCorrectedByWhatTheChecksOffer) {
  constexpr int kSets = 2;
  const auto& kind = seededMistakes().at(GetParam());
  SeededRandom random(23);
  int corrected = 0;
  for (std::uint64_t number = 0; number < 120 && corrected < kSets; ++number) {
    auto set = cleanSet(number);
    const auto correction = set ? kind.make(*set, random) : std::nullopt;
    if (correction == "sigma=*") GTEST_SKIP() << "no unit is that small";
    if (!correction || correction == "joint-zero=theta4") continue;
    const auto checks = checksOf(*set).checks;
    const auto named = std::ranges::find_if(checks, [&](const MeasurementCheck& check) {
      return judgeNaming(kind, *correction, {{check}, {}}) == Naming::kRight;
    });
    if (named == checks.end()) continue;
    const std::string assume = named->assume;
    ++corrected;
    const double chi2 = chi2Corrected(*set, assume);
    EXPECT_GT(chi2, 0.5) << assume << " in " << set->name;
    EXPECT_LT(chi2, 2) << assume << " in " << set->name;
  }
  EXPECT_GT(corrected, 0) << kind.label;
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, EachMistake, ::testing::Range<std::size_t>(0, seededMistakes().size()));

// No finding states an error below the noise, even if the measurements are so few that the free parameters fit them
// exactly.
TEST(MeasurementChecksOf, ErrorsAreQuotedNoLowerThanTheNoise) {
  int quoted = 0;
  for (const auto& kind : seededMistakes())
    for (const std::uint64_t number : {0u, 4u})
      for (const std::size_t count : {3 + number / 2, 12ul}) {
        SeededRandom random(number + count);
        auto set = cleanSet(number);
        ASSERT_TRUE(set);
        set->table.measurements.resize(std::min(count, set->table.measurements.size()));
        if (!kind.make(*set, random)) continue;
        double noise = std::numeric_limits<double>::infinity();
        for (const auto& m : set->table.measurements) noise = std::min(noise, m.sigma);
        for (const auto& check : checksOf(*set).checks) {
          if (check.name == "hole" || !findMistakeKind(check.name))
            continue;  // a hole's error belongs to one measurement
          for (const double error : {check.error_as_is, check.error_if_corrected}) {
            if (!std::isfinite(error)) continue;
            ++quoted;
            // With a wrong coordinate unit the noise is wrong, too; the smallest unit is a thousandth of the largest.
            EXPECT_GE(error, noise * (check.assume.starts_with("coord") ? 1e-3 : 0.999))
                << kind.label << ": " << check.sentence;
          }
        }
      }
  EXPECT_GT(quoted, 20);
}

TEST(MeasurementChecksOf, CleanMeasurementsSuspectNothing) {
  for (std::uint64_t number = 0; number < 10; ++number) {
    const auto set = cleanSet(number);
    ASSERT_TRUE(set) << number;
    const auto checks = checksOf(*set);
    EXPECT_EQ(firstMistake(checks), nullptr) << set->name << ": " << checks.checks.front().sentence;
  }
}

TEST(MeasurementChecksOf, PhysicsIsNoMistake) {
  static constexpr const char* kHidden[] = {"backlash@tool.z:0.2deg", "joint-offset@theta3:3deg",
                                            "tool-weight@tool:-0.48", "hysteresis@theta2:0.2deg"};
  for (const char* hidden : kHidden) {
    const auto set = simulatedSet("bench.yaml", "bench", 60, {hidden}, 3);
    ASSERT_TRUE(set) << hidden;
    const auto checks = checksOf(*set);
    EXPECT_EQ(firstMistake(checks), nullptr) << hidden << ": " << checks.checks.front().sentence;
  }
}

// Drifts, and slips of the base in measurements with times, are left to the diagnosis: no mistake that begins at a
// measurement is proposed for them.
TEST(MistakesFromAMeasurement, AreNotSeenInWhatCreeps) {
  static constexpr const char* kHidden[] = {"base-drift@base", "thermal-growth@arm", "base-slip@base"};
  for (const char* hidden : kHidden)
    for (const std::uint64_t seed : {1, 2, 3}) {
      const auto set = simulatedSet("bowl.yaml", "bench", 60, {hidden}, seed);
      ASSERT_TRUE(set) << hidden;
      for (const auto& check : checksOf(*set).checks)
        EXPECT_EQ(check.assume.find('@'), std::string::npos) << hidden << ": " << check.sentence;
    }
}

/// A zero that drifts as the arm warms up, by as much as a step of twenty times the noise, is not named as a mistake
/// that begins at a measurement.
TEST(MistakesFromAMeasurement, AreNotSeenInAZeroThatCreeps) {
  for (const std::uint64_t number : {0, 3, 5, 8})
    for (const double share : {0.1, 0.4, 3.}) {
      auto set = cleanSet(number);
      ASSERT_TRUE(set);
      auto& measurements = set->table.measurements;
      const auto count = static_cast<double>(measurements.size());
      for (std::size_t k = 0; k < measurements.size(); ++k)
        measurements[k].q[1] +=
            0.0015 * (1 - std::exp(-static_cast<double>(k) / (share * count))) / (1 - std::exp(-1 / share));
      for (const auto& check : checksOf(*set).checks)
        EXPECT_EQ(check.assume.find('@'), std::string::npos) << set->name << " " << share << ": " << check.sentence;
    }
}

// Once the measurements are corrected as proposed, the checks find no further mistake in them.
TEST(MistakesFromAMeasurement, AreGoneOnceCorrected) {
  int corrected = 0;
  for (const char* label : {"counts lost midway", "another target midway", "tracker bumped midway"})
    for (std::uint64_t number = 0; number < 4; ++number) {
      SeededRandom random(number + 5);
      auto set = cleanSet(number);
      const auto correction = set ? seededMistake(label).make(*set, random) : std::nullopt;
      if (!correction) continue;
      const auto checks = checksOf(*set);
      const auto* mistake = firstMistake(checks);
      if (!mistake || mistake->assume.find('@') == std::string::npos) continue;
      const std::string assume = mistake->assume;
      (void)app::takeAssumptions({assume}, set->table, set->cell);
      const auto again = checksOf(*set);
      EXPECT_EQ(firstMistake(again), nullptr) << assume << ": " << again.checks.front().sentence;
      ++corrected;
    }
  EXPECT_GE(corrected, 6);
}

// If one mistake affects the whole table and another starts within it, both are named, in the order of their
// correction.
TEST(MistakesFromAMeasurement, AreNamedBesideOthers) {
  int made = 0, named = 0;
  std::string found;
  for (const char* other : {"coordinates in mm", "one axis mirrored", "a joint's sign", "radians under deg"})
    for (const char* label : {"counts lost midway", "another target midway"}) {
      SeededRandom random(29);
      auto set = cleanSet(3 + 5 * static_cast<std::uint64_t>(made % 3));
      ASSERT_TRUE(set);
      const auto step = seededMistake(label).make(*set, random);
      const auto second_mistake = seededMistake(other).make(*set, random);
      if (!step || !second_mistake) continue;
      ++made;
      const auto checks = checksOf(*set);
      const auto* mistake = firstMistake(checks);
      const std::string assume = mistake ? mistake->assume : "nothing";
      named +=
          assume.starts_with(*second_mistake) && assume.find(step->substr(0, step->find('='))) != std::string::npos;
      found += *second_mistake + " + " + *step + ": " + assume + "\n";
    }
  ASSERT_GE(made, 6);
  EXPECT_GE(named, made - 1) << found;
}

// A coupling of two joints looks like a wrong zero that leaves an error, and a drift of the base like a move of it.
TEST(MeasurementChecksOf, LargeEffectsInFewMeasurementsAreNoMistake) {
  for (const std::uint64_t number : {0, 3, 12, 15, 85, 170}) {
    const auto set = hidingSet(number);
    ASSERT_TRUE(set) << number;
    const auto checks = checksOf(*set);
    EXPECT_EQ(firstMistake(checks), nullptr) << set->name << ": " << checks.checks.front().sentence;
  }
}

TEST(MeasurementChecksOf, AnArmThriceAsSoftAsDrawnIsNoMistake) {
  const auto set = simulatedSet("bench.yaml", "bench", 60, {}, 4, [](app::SimulationTask& task) {
    for (auto& row : task.truth.arm.rows) row.joint_stiffness /= 3;
  });
  ASSERT_TRUE(set);
  EXPECT_EQ(firstMistake(checksOf(*set)), nullptr);
}

TEST(MeasurementChecksOf, BeamsThatBendTooFarForTheirSegmentsAreNamed) {
  auto set = simulatedSet("bench.yaml", "bench", 60, {}, 4);
  ASSERT_TRUE(set);
  const auto has = [&] {
    const auto checks = checksOf(*set).checks;
    return std::any_of(checks.begin(), checks.end(), [](const auto& check) { return check.name == "segments"; });
  };
  EXPECT_FALSE(has());
  for (auto& row : set->cell.arm.rows)
    if (row.beam) row.beam->E /= 30;
  EXPECT_TRUE(has());
  for (auto& row : set->cell.arm.rows)
    if (row.beam) row.beam->segments = 32;
  EXPECT_FALSE(has());
}

// Returns an elbow arm of six joints whose standard Denavit-Hartenberg parameters are stated as modified ones.
PlacedArm elbowArm() {
  PlacedArm placed;
  const double alpha[] = {90, 0, -90, 90, -90, 0}, a[] = {0, 0.43, 0.02, 0, 0, 0}, d[] = {0.6, 0.1, 0.15, 0.43, 0, 0.1};
  for (int k = 0; k < 6; ++k) {
    deflection::Row<double> row;
    row.name = "link" + std::to_string(k + 1);
    row.placement = deflection::DenavitHartenberg<double>{alpha[k] * kDegree, a[k], d[k], 0};
    row.joint.name = "q" + std::to_string(k + 1);
    row.joint.type = deflection::JointType::kRevolute;
    row.joint.lower = -2.5;
    row.joint.upper = 2.5;
    placed.arm.rows.push_back(row);
  }
  placed.arm.p_LT = {0.05, 0, 0.1};
  placed.base_poses = {{"", poseOf({0.3, -0.2, 0.1}, {0, 0, 0.3}), true}};
  return placed;
}

TEST(MeasurementChecksOf, RowsByTheStandardConventionAreNamed) {
  for (const bool is_standard : {true, false}) {
    PlacedArm real = elbowArm();
    if (is_standard) deflection::readAsStandard(real.arm.rows);
    MeasurementMaker maker(real, 5, MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kPosition, 40);
    const auto checks = checkMeasurements({elbowArm(), maker.measurements, {{"tool.tip"}, true}, {}});
    const auto* gross = firstMistake(checks);
    EXPECT_EQ(gross != nullptr, is_standard);
    if (is_standard && gross) {
      EXPECT_EQ(gross->name, "convention");
      EXPECT_LT(gross->error_if_corrected, 1e-3);
    }
  }
}

TEST(MeasurementChecksOf, ATwistWithTheOtherSignIsNamed) {
  PlacedArm real = elbowArm();
  auto& alpha = std::get<deflection::DenavitHartenberg<double>>(real.arm.rows[4].placement).alpha;
  alpha = -alpha;
  MeasurementMaker maker(real, 6, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 40);
  const auto checks = checkMeasurements({elbowArm(), maker.measurements, {{"tool.tip"}, true}, {}});
  const auto* gross = firstMistake(checks);
  ASSERT_NE(gross, nullptr);
  EXPECT_EQ(gross->name, "twist");
  EXPECT_NE(gross->sentence.find("link5"), std::string::npos) << gross->sentence;
  EXPECT_LT(gross->error_if_corrected, 1e-3);
}

// For at least 10 of the first 12 pairs of mistakes, the checks name both, or propose a correction with which the
// measurements fit as well as the clean ones. studies/measurement_checks.cpp counts five hundred pairs.
TEST(PairsOfMistakes, AreBothNamed) {
  constexpr int kPairs = 12;
  int made = 0, named = 0;
  std::string found;
  for (std::uint64_t number = 1; made < kPairs && number < 100; ++number) {
    const auto pair = seededPair(number);
    if (!pair) continue;
    ++made;
    const auto checks = checksOf(pair->set);
    const auto naming = judgePair(*pair, checks);
    named += naming == PairNaming::kBoth || naming == PairNaming::kAsGood;
    found += fmt::format("{} in {}: {}\n", pair->label, pair->set.name,
                         checks.checks.empty() ? "nothing" : checks.checks.front().assume);
  }
  ASSERT_EQ(made, kPairs);
  EXPECT_GE(named, 10) << found;
}

// If some joints are rounded to one step and some to another, the remark names both steps.
TEST(MeasurementChecksOf, JointsRoundedEachByItselfAreRemarkedOn) {
  auto set = cleanSet(0);
  ASSERT_TRUE(set);
  for (auto& m : set->table.measurements)
    for (Eigen::Index j = 0; j < m.q.size(); ++j) {
      const double step = j % 2 ? 0.005 : 0.5 * std::numbers::pi / 180;
      m.q[j] = std::round(m.q[j] / step) * step;
    }
  const auto checks = checksOf(*set).checks;
  const auto said = std::ranges::find(checks, std::string("rounded-joints"), &MeasurementCheck::name);
  ASSERT_NE(said, checks.end());
  EXPECT_NE(said->sentence.find("0.5 deg"), std::string::npos) << said->sentence;
  EXPECT_NE(said->sentence.find("0.005 rad"), std::string::npos) << said->sentence;
}

// If all joints are read in pulses, the checks find their scales or ask the user for them.
TEST(MeasurementChecksOf, PulsesOfSeveralJointsAreAskedFor) {
  auto set = cleanSet(0);
  ASSERT_TRUE(set);
  for (auto& m : set->table.measurements) m.q *= 1000;
  const auto checks = checksOf(*set).checks;
  EXPECT_NE(std::ranges::find(checks, std::string("joint-scale"), &MeasurementCheck::name), checks.end());
}

/// Joint readings rounded as on a display get a remark; measurements with all digits get none.
TEST(MeasurementChecksOf, RoundedJointsAreRemarkedOn) {
  for (const double degrees : {0., 0.1, 0.5}) {
    auto set = cleanSet(0);
    ASSERT_TRUE(set);
    for (auto& m : set->table.measurements)
      for (double& q : m.q) {
        if (degrees == 0) continue;
        const double step = degrees * std::numbers::pi / 180;
        q = std::round(q / step) * step;
      }
    const auto checks = checksOf(*set);
    const bool is_said = std::ranges::any_of(
        checks.checks, [](const MeasurementCheck& check) { return check.name == "rounded-joints"; });
    EXPECT_EQ(is_said, degrees > 0) << degrees;
  }
}

TEST(MeasurementChecksOf, MissingColumnsSayWhatTheyWouldShow) {
  const auto set = simulatedSet("bench.yaml", "bench", 12, {}, 5);
  ASSERT_TRUE(set);
  auto measurements = *set;
  for (auto& m : measurements.table.measurements) {
    m.approach_directions.clear();
    m.conditions = {};
  }
  std::vector<std::string> columns;
  for (const auto& missing : checksOf(measurements).missing) columns.push_back(missing.column);
  EXPECT_EQ(columns, (std::vector<std::string>{"<joint>_dir", "temperature", "time"}));
}

// If the measured values are shifted by a row, the direction of a tilt and the tool point of a position are shifted
// with them.
TEST(MeasurementChecksOf, ShiftedRowsKeepWholeWhatWasMeasured) {
  std::vector<Measurement> measurements(3);
  measurements[1].kind = MeasurementKind::kTilt;
  measurements[1].direction_W = Eigen::Vector3d::UnitZ();
  measurements[1].row = 2;
  measurements[2].p_TQ = Eigen::Vector3d(0.1, 0, 0);
  mistakes::shifted_rows::shift(1, measurements);
  ASSERT_EQ(measurements.size(), 2u);
  EXPECT_EQ(measurements[0].kind, MeasurementKind::kTilt);
  EXPECT_TRUE(measurements[0].direction_W);
  EXPECT_EQ(measurements[0].row, 2);
  EXPECT_FALSE(measurements[1].direction_W || measurements[1].row);
  EXPECT_TRUE(measurements[1].p_TQ);
}

CheckedMeasurements checkedOf(const SeededSet& set) {
  return {app::startOf(set.cell, set.table.measurements), set.table.measurements, app::freeNumbersOf(set.cell),
          set.table.units, nullptr};
}

TEST(MeasurementChecksOf, CopiesAreTakenOutWhereNoTwoMeasurementsWouldBeAlike) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 7);
  ASSERT_TRUE(set);
  auto clean = checkedOf(*set);
  EXPECT_FALSE(takeCopiesOut(clean));
  EXPECT_EQ(clean.measurements.size(), 30U);
  for (int k : {3, 3, 17}) {
    set->table.measurements.push_back(set->table.measurements[static_cast<std::size_t>(k)]);
    set->table.measurements.back().id += "-again" + std::to_string(set->table.measurements.size());
  }
  auto copied = checkedOf(*set);
  const auto check = takeCopiesOut(copied);
  ASSERT_TRUE(check);
  EXPECT_EQ(check->severity, CheckSeverity::kRemark);
  EXPECT_EQ(copied.measurements.size(), 30U);
  EXPECT_EQ(copied.measurements.back().id, clean.measurements.back().id);
}

// Measurements that are equal only because they are coarse, as a dial gauge's often are, are not taken for copies.
TEST(MeasurementChecksOf, CoarseMeasurementsThatAgreeAreNoCopies) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 7);
  ASSERT_TRUE(set);
  const double step = 0.01 * set->table.units.coordinates.factor;
  for (auto& m : set->table.measurements) {
    *m.p_W = (*m.p_W / step).array().round().matrix() * step;
    m.sigma = 3 * step;
  }
  set->table.measurements.push_back(set->table.measurements.front());
  set->table.measurements.back().id += "-again";
  auto checked = checkedOf(*set);
  EXPECT_FALSE(takeCopiesOut(checked));
  EXPECT_EQ(checked.measurements.size(), 31U);
}

TEST(MeasurementChecksOf, ManyMeasurementsAreThinnedOut) {
  auto set = simulatedSet("bench.yaml", "bench", 120, {}, 6);
  ASSERT_TRUE(set);
  const auto few = set->table.measurements;
  for (int copy = 1; copy < 100; ++copy)
    for (auto m : few) {
      m.id += "-" + std::to_string(copy);
      m.conditions[Condition::kTime] += copy;
      set->table.measurements.push_back(m);
    }
  SeededRandom random(1);
  ASSERT_TRUE(seeded::jointSign(*set, random));
  const auto checks = checksOf(*set);
  ASSERT_NE(firstMistake(checks), nullptr);
  EXPECT_EQ(firstMistake(checks)->name, "joint-sign");
}

// A miscount of holes is refused as an explanation if it places a touched hole off the sheet. Otherwise this touch
// would be excluded, which would improve the fit of the others.
TEST(MistakeKinds, HolesWereNotCountedSoThatOneIsMissing) {
  const app::Cell cell = shippedCell("mockup.yaml");
  CheckedMeasurements checked;
  checked.sheet = &*cell.sheet;
  for (const auto& [row, column] : {std::pair{1, 40}, std::pair{20, 40}}) {
    const auto& tube = *cell.sheet->find(row, column);
    Measurement touch;
    touch.kind = MeasurementKind::kTouch;
    touch.point = tubesheets::tubeName(row, column);
    touch.p_W = Eigen::Vector3d(tube.x, tube.y, 0);
    checked.measurements.push_back(touch);
  }
  const MistakeKind& holes = *findMistakeKind("holes");
  EXPECT_FALSE(holes.correction(checked, "R-1"));
  const auto correction = holes.correction(checked, "R+1");
  ASSERT_TRUE(correction);
  auto measurements = checked.measurements;
  correction->apply(measurements);
  ASSERT_EQ(measurements.size(), 2U);
  EXPECT_EQ(measurements[0].point, "R2C40");
  EXPECT_EQ(measurements[1].p_W->y(), cell.sheet->find(21, 40)->y);
}

}  // namespace
}  // namespace tubeplan::calibration
