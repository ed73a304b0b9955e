#include "calibration/measurement_checks/joint_limits.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "app/files/input_error.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kTurn = 2 * std::numbers::pi, kDeg = std::numbers::pi / 180;

deflection::Joint<double> jointBetween(double lower, double upper) {
  deflection::Joint<double> joint;
  joint.type = deflection::JointType::kRevolute;
  joint.lower = lower * kDeg;
  joint.upper = upper * kDeg;
  return joint;
}

TEST(JointLimits, AReadingPastThemIsTakenOneTurnBackWhereThatIsWithin) {
  const struct {
    double lower, upper, read, back;  // deg
  } cases[] = {{-180, 180, 212, -148}, {-180, 180, 359.5, -0.5}, {0, 360, -30, 330},   {-90, 200, -150, 210},
               {-360, 360, 400, 40},   {-120, 120, 164, 164},    {-180, 180, 572, 572}};
  for (const auto& c : cases) {
    const auto back = oneTurnBack(jointBetween(c.lower, c.upper), c.read * kDeg);
    const bool is_within = c.back != c.read && c.back <= c.upper;
    ASSERT_EQ(back.has_value(), is_within) << c.read;
    EXPECT_NEAR(back.value_or(c.back * kDeg), c.back * kDeg, 1e-12) << c.read;
  }
  auto slide = jointBetween(-180, 180);
  slide.type = deflection::JointType::kPrismatic;
  EXPECT_FALSE(oneTurnBack(slide, 4));
}

/// Readings of the bench whose first joint's encoder counts from 0 to 360 deg, as a file.
app::ReadingsWithChecks readUnwound(SeededSet& set, const std::function<void(std::vector<Measurement>&)>& change) {
  change(set.table.readings);
  return app::parseAndCheck(app::measurementsCsv(set.table.readings, set.cell.arm, set.cell.units), "m.csv", set.cell,
                            {});
}

void countFromZero(std::vector<Measurement>& readings) {
  for (auto& m : readings)
    if (m.q[0] < 0) m.q[0] += kTurn;
}

TEST(JointLimits, ReadingsOfAnEncoderFromZeroToATurnAreTakenBackAndSaidSo) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  const auto original = set->table.readings;
  const auto read = readUnwound(*set, countFromZero);
  ASSERT_EQ(read.readings.size(), original.size());
  for (std::size_t k = 0; k < original.size(); ++k)
    EXPECT_NEAR(read.readings[k].q[0], original[k].q[0], 1e-6) << original[k].id;
  const auto said = std::ranges::find(read.checks.checks, std::string("whole-turn"), &MeasurementCheck::name);
  ASSERT_NE(said, read.checks.checks.end());
  EXPECT_EQ(said->severity, CheckSeverity::kRemark);
  EXPECT_NE(said->sentence.find(set->cell.arm.joint(0).name), std::string::npos) << said->sentence;
  EXPECT_EQ(grossMistake(read.checks), nullptr);
}

// One reading that no turn brings back speaks against the encoder's count.
TEST(JointLimits, AJointWithAReadingThatNoTurnBringsBackIsRefused) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  EXPECT_THROW((void)readUnwound(*set,
                                 [](std::vector<Measurement>& readings) {
                                   countFromZero(readings);
                                   readings.front().q[0] = 3 * kTurn;
                                 }),
               app::InputError);
}

// A count from zero and another mistake: the count is settled, and the mistake still named.
TEST(JointLimits, AnotherMistakeBesideTheTurnIsNamed) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  const auto read = readUnwound(*set, [](std::vector<Measurement>& readings) {
    countFromZero(readings);
    for (auto& m : readings) m.q[2] *= -1;
  });
  const auto* gross = grossMistake(read.checks);
  ASSERT_NE(gross, nullptr);
  EXPECT_EQ(gross->assume, "joint-sign=theta3");
}

}  // namespace
}  // namespace tubeplan::calibration
