#include "calibration/measurement_checks/gravity_direction.hpp"

#include <gtest/gtest.h>

#include "tests/calibration/synthetic_readings.hpp"

namespace tubeplan::calibration {
namespace {

/// Checks of 40 readings of the Cobra under such gravity, held against one under gravity downwards.
MeasurementChecks checksUnder(const Eigen::Vector3d& gravity_W, bool is_base_known) {
  PlacedArm real = cobra();
  real.arm.gravity_W = gravity_W;
  ReadingMaker maker(real, 8, ReadingMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 40);
  PlacedArm start = cobra();
  start.base_poses.front().is_known = is_base_known;
  return checkMeasurements({start, maker.readings, {{"tool.tip"}, true}, {}});
}

TEST(GravityDirection, IsNamedWithTheKeyOfTheCell) {
  const struct {
    Eigen::Vector3d gravity_W;
    const char* key;
  } cases[] = {{Eigen::Vector3d::UnitZ(), "gravity: [0, 0, 1]"},
               {-Eigen::Vector3d::UnitY(), "gravity: [0, -1, 0]"},
               {Eigen::Vector3d::UnitX(), "gravity: [1, 0, 0]"}};
  for (const auto& c : cases) {
    const auto checks = checksUnder(c.gravity_W, true);
    const auto* gross = grossMistake(checks);
    ASSERT_NE(gross, nullptr) << c.key;
    EXPECT_EQ(gross->name, "gravity") << gross->sentence;
    EXPECT_NE(gross->sentence.find(c.key), std::string::npos) << gross->sentence;
    EXPECT_LT(gross->error_if_mended, gross->error_as_is / 5);
  }
}

TEST(GravityDirection, IsLeftAloneWhereItIsRight) {
  for (const bool is_base_known : {true, false})
    EXPECT_EQ(grossMistake(checksUnder(-Eigen::Vector3d::UnitZ(), is_base_known)), nullptr);
}

}  // namespace
}  // namespace tubeplan::calibration
