#include "calibration/measurement_checks/joint_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "app/storage/input_error.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi, kDeg = std::numbers::pi / 180;

deflection::Joint<double> jointBetween(double lower, double upper) {
  deflection::Joint<double> joint;
  joint.type = deflection::JointType::kRevolute;
  joint.lower = lower * kDeg;
  joint.upper = upper * kDeg;
  return joint;
}

TEST(JointLimits, AMeasurementPastThemIsTakenOneTurnBackWhereThatIsWithin) {
  const struct {
    double lower, upper, read, back;  // [deg]
  } cases[] = {{-180, 180, 212, -148}, {-180, 180, 359.5, -0.5}, {0, 360, -30, 330},   {-90, 200, -150, 210},
               {-360, 360, 400, 40},   {-120, 120, 164, 164},    {-180, 180, 572, 572}};
  for (const auto& c : cases) {
    const auto back = shiftedByOneTurn(jointBetween(c.lower, c.upper), c.read * kDeg);
    const bool is_within = c.back != c.read && c.back <= c.upper;
    ASSERT_EQ(back.has_value(), is_within) << c.read;
    EXPECT_NEAR(back.value_or(c.back * kDeg), c.back * kDeg, 1e-12) << c.read;
  }
  auto slide = jointBetween(-180, 180);
  slide.type = deflection::JointType::kPrismatic;
  EXPECT_FALSE(shiftedByOneTurn(slide, 4));
}

TEST(JointLimits, AHairIsAThousandthOfTheRange) {
  const struct {
    double read;  // [deg], with limits of -120 and 80
    bool is_past;
  } cases[] = {{80.19, false}, {80.21, true}, {-120.19, false}, {-120.21, true}, {std::nan(""), true}};
  for (const auto& c : cases) EXPECT_EQ(isPastLimit(jointBetween(-120, 80), c.read * kDeg), c.is_past) << c.read;
  auto endless = jointBetween(-120, 80);
  endless.upper = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isPastLimit(endless, 1e6));
  EXPECT_TRUE(isPastLimit(endless, -120.1 * kDeg));
}

/// Applies `change` to the measurements of a set, writes them in the format of a measurement file, and returns what is
/// read back.
app::MeasurementsWithChecks readUnwound(SeededSet& set, const std::function<void(std::vector<Measurement>&)>& change) {
  change(set.table.measurements);
  return app::parseAndCheck(app::measurementsCsv(set.table.measurements, set.cell.arm, set.cell.units), "m.csv",
                            set.cell, {});
}

void countFromZero(std::vector<Measurement>& measurements) {
  for (auto& m : measurements)
    if (m.q[0] < 0) m.q[0] += kFullTurn;
}

TEST(JointLimits, MeasurementsOfAnEncoderFromZeroToATurnAreTakenBackAndSaidSo) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  const auto original = set->table.measurements;
  const auto read = readUnwound(*set, countFromZero);
  ASSERT_EQ(read.measurements.size(), original.size());
  for (std::size_t k = 0; k < original.size(); ++k)
    EXPECT_NEAR(read.measurements[k].q[0], original[k].q[0], 1e-6) << original[k].id;
  const auto said = std::ranges::find(read.checks.checks, std::string("whole-turn"), &MeasurementCheck::name);
  ASSERT_NE(said, read.checks.checks.end());
  EXPECT_EQ(said->severity, CheckSeverity::kRemark);
  EXPECT_NE(said->sentence.find(set->cell.arm.joint(0).name), std::string::npos) << said->sentence;
  EXPECT_EQ(firstMistake(read.checks), nullptr);
}

// A measurement 0.1 deg beyond a joint limit is accepted with a remark that names it; a file with a measurement 0.3 deg
// beyond the limit is refused.
TEST(JointLimits, AMeasurementAHairPastIsTakenAndSaidSo) {
  const auto raised = [](double hair) {
    return [hair](std::vector<Measurement>& measurements) { measurements[4].q[1] = (180 + hair) * kDeg; };
  };
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3), other = set;
  ASSERT_TRUE(set);
  const auto read = readUnwound(*set, raised(0.1));
  EXPECT_NEAR(read.measurements[4].q[1], 180.1 * kDeg, 1e-9);
  const auto said = std::ranges::find(read.checks.checks, std::string("past-limit"), &MeasurementCheck::name);
  ASSERT_NE(said, read.checks.checks.end());
  EXPECT_NE(said->sentence.find("theta2 of reading " + read.measurements[4].id), std::string::npos) << said->sentence;
  EXPECT_THROW((void)readUnwound(*other, raised(0.3)), app::InputError);
}

// A file is refused if one turn does not bring all readings of a joint within its limits, because its encoder then does
// not count from 0 to 360 deg.
TEST(JointLimits, AJointWithAMeasurementThatNoTurnBringsBackIsRefused) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  EXPECT_THROW((void)readUnwound(*set,
                                 [](std::vector<Measurement>& measurements) {
                                   countFromZero(measurements);
                                   measurements.front().q[0] = 3 * kFullTurn;
                                 }),
               app::InputError);
}

// If one encoder counts from zero and another joint has the wrong sign, the readings of the encoder are corrected
// and the wrong sign is still named.
TEST(JointLimits, AnotherMistakeBesideTheTurnIsNamed) {
  auto set = simulatedSet("bench.yaml", "bench", 30, {}, 3);
  ASSERT_TRUE(set);
  const auto read = readUnwound(*set, [](std::vector<Measurement>& measurements) {
    countFromZero(measurements);
    for (auto& m : measurements) m.q[2] *= -1;
  });
  const auto* gross = firstMistake(read.checks);
  ASSERT_NE(gross, nullptr);
  EXPECT_EQ(gross->assume, "joint-sign=theta3");
}

}  // namespace
}  // namespace tubeplan::calibration
