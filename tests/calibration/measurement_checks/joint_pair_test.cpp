// If two joint columns contain the motor angles of a differential, the checks name and correct them, also in
// combination with another mistake.
#include "calibration/measurement_checks/joint_pair.hpp"

#include <gtest/gtest.h>

#include "app/formats/measurements/assumptions.hpp"
#include "tests/calibration/measurement_checks/seeded_pairs.hpp"

namespace tubeplan::calibration {
namespace {

CheckedMeasurements checkedMotors(const SeededSet& set) {
  return {app::startOf(set.cell, set.table.measurements), set.table.measurements, app::freeNumbersOf(set.cell),
          set.table.units, nullptr};
}

TEST(JointPair, IsOfTwoJointsAndSharesThatPartThem) {
  const auto set = cleanSet(0);
  ASSERT_TRUE(set);
  const auto checked = checkedMotors(*set);
  for (const char* value : {"theta3:theta4:0.5:0.5:0.5:-0.5", "theta4:theta3:1:1:-1:1", "theta1:theta4:2:0:1:1"})
    EXPECT_TRUE(mistakes::joint_pair::correction(checked, value)) << value;
  for (const char* value :
       {"", "theta3:theta4", "theta3:theta4:0.5:0.5:0.5", "theta3:theta3:0.5:0.5:0.5:-0.5", "theta3:theta4:1:1:1:1",
        "theta3:theta4:1:1:1:x", "theta3:theta4:1:1:1:nan", "theta3:theta9:1:1:1:-1", "theta3:theta4:0:0:0:0"})
    EXPECT_FALSE(mistakes::joint_pair::correction(checked, value)) << value;
}

TEST(JointPair, TakesSensesOfMotionThatTheMotorsTell) {
  struct Row {
    int first, second, sum, difference;
  };
  for (const Row& row :
       {Row{1, 1, 1, 0}, Row{-1, -1, -1, 0}, Row{1, -1, 0, 1}, Row{-1, 1, 0, -1}, Row{0, 1, 0, 0}, Row{0, 0, 0, 0}}) {
    auto set = cleanSet(0);
    ASSERT_TRUE(set);
    set->table.measurements.resize(1);
    auto& measurement = set->table.measurements.front();
    measurement.q << 0.1, 0.2, 0.7, 0.3;
    measurement.approach_directions = {1, 1, row.first, row.second};
    const auto correction = mistakes::joint_pair::correction(checkedMotors(*set), "theta3:theta4:0.5:0.5:0.5:-0.5");
    ASSERT_TRUE(correction);
    correction->apply(set->table.measurements);
    EXPECT_NEAR(measurement.q[2], 0.5, 1e-12);
    EXPECT_NEAR(measurement.q[3], 0.2, 1e-12);
    EXPECT_EQ(measurement.approach_directions, (std::vector<int>{1, 1, row.sum, row.difference}));
  }
}

// If the columns contain the motor angles, and a unit, sign or coordinate axis is wrong, too, the proposed correction
// restores the clean measurements in all cases but at most one.
TEST(JointPair, IsNamedBesideAnotherMistake) {
  int made = 0, corrected = 0;
  std::string found;
  for (const char* other : {"coordinates in mm", "two axes exchanged", "a joint's sign"})
    for (const std::uint64_t number : {0, 2, 3}) {
      auto set = cleanSet(number);
      ASSERT_TRUE(set);
      SeededRandom random(number + 7);
      SeededPair pair{*set, set->table.measurements, {}, other};
      for (auto& m : pair.set.table.measurements) {
        const double bend = m.q[2], turn = m.q[3];
        m.q[2] = bend + turn, m.q[3] = bend - turn;
      }
      if (!seededMistake(other).make(pair.set, random)) continue;
      ++made;
      const auto checks = checksOf(pair.set);
      const auto* gross = firstMistake(checks);
      if (gross && distanceAfterCorrection(pair, gross->assume) < 1e-6)
        ++corrected;
      else
        found += fmt::format("{} in {}: {}\n", other, pair.set.name, gross ? gross->assume : "nothing");
    }
  EXPECT_GE(made, 6);
  EXPECT_GE(corrected, made - 1) << found;
}

}  // namespace
}  // namespace tubeplan::calibration
