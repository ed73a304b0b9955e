// Ordinary mistakes with readings are named, none is seen where there is none, and each is mended by what is proposed.
// The study tests/study/measurement_checks does the same at length.
#include "calibration/measurement_checks/measurement_checks.hpp"

#include <gtest/gtest.h>

#include "tests/calibration/measurement_checks/seeded_mistakes.hpp"

namespace tubeplan::calibration {
namespace {

class MeasurementChecks : public ::testing::TestWithParam<std::size_t> {};

// Three sets each: a single one may be of the few that priors explain. The last joint's zero is left out: to tips alone
// it is a tool mounted elsewhere, and nothing that the readings hold could say which.
TEST_P(MeasurementChecks, NameTheMistake) {
  constexpr int kSets = 3;
  const auto& kind = seededMistakes().at(GetParam());
  SeededRandom random(17);
  int made = 0, named = 0;
  std::string found;
  for (std::uint64_t number = 0; number < 120 && made < kSets; ++number) {
    auto set = cleanSet(number);
    const auto mend = set ? kind.make(*set, random) : std::nullopt;
    if (!mend || *mend == "joint-zero=theta4") continue;
    ++made;
    const auto checks = checksOf(*set);
    const Naming naming = judgeNaming(kind, *mend, checks);
    named += naming == Naming::kRight || naming == Naming::kEqually;
    found += fmt::format("{} in {}: found {}\n", *mend, set->name,
                         checks.checks.empty() ? "nothing" : checks.checks.front().sentence);
  }
  ASSERT_EQ(made, kSets) << "too few sets have room for " << kind.label;
  EXPECT_GE(named, kSets - 1) << found;
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, MeasurementChecks, ::testing::Range<std::size_t>(0, seededMistakes().size()));

TEST(MeasurementChecksOf, CleanReadingsSuspectNothing) {
  for (std::uint64_t number = 0; number < 10; ++number) {
    const auto set = cleanSet(number);
    ASSERT_TRUE(set) << number;
    const auto checks = checksOf(*set);
    EXPECT_EQ(grossMistake(checks), nullptr) << set->name << ": " << checks.checks.front().sentence;
  }
}

TEST(MeasurementChecksOf, PhysicsIsNoMistake) {
  static constexpr const char* kHidden[] = {"backlash@tool.z:0.2deg", "joint-offset@theta3:3deg",
                                            "tool-weight@tool:-0.48", "hysteresis@theta2:0.2deg"};
  for (const char* hidden : kHidden) {
    const auto set = simulatedSet("bench.yaml", "bench", 60, {hidden}, 3);
    ASSERT_TRUE(set) << hidden;
    const auto checks = checksOf(*set);
    EXPECT_EQ(grossMistake(checks), nullptr) << hidden << ": " << checks.checks.front().sentence;
  }
}

TEST(MeasurementChecksOf, AnArmThriceAsSoftAsDrawnIsNoMistake) {
  const auto set = simulatedSet("bench.yaml", "bench", 60, {}, 4, [](app::SimulationTask& task) {
    for (auto& row : task.truth.arm.rows) row.joint_stiffness /= 3;
  });
  ASSERT_TRUE(set);
  EXPECT_EQ(grossMistake(checksOf(*set)), nullptr);
}

TEST(MeasurementChecksOf, MissingColumnsSayWhatTheyWouldShow) {
  const auto set = simulatedSet("bench.yaml", "bench", 12, {}, 5);
  ASSERT_TRUE(set);
  auto readings = *set;
  for (auto& m : readings.table.readings) {
    m.approach_directions.clear();
    m.temperature = m.time = std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<std::string> columns;
  for (const auto& missing : checksOf(readings).missing) columns.push_back(missing.column);
  EXPECT_EQ(columns, (std::vector<std::string>{"<joint>_dir", "temperature", "time"}));
}

TEST(MeasurementChecksOf, ManyReadingsAreThinnedOut) {
  auto set = simulatedSet("bench.yaml", "bench", 120, {}, 6);
  ASSERT_TRUE(set);
  const auto few = set->table.readings;
  for (int copy = 1; copy < 100; ++copy)
    for (auto m : few) {
      m.id += "-" + std::to_string(copy);
      m.time += copy;
      set->table.readings.push_back(m);
    }
  SeededRandom random(1);
  ASSERT_TRUE(seeded::jointSign(*set, random));
  const auto checks = checksOf(*set);
  ASSERT_NE(grossMistake(checks), nullptr);
  EXPECT_EQ(grossMistake(checks)->name, "joint-sign");
}

}  // namespace
}  // namespace tubeplan::calibration
