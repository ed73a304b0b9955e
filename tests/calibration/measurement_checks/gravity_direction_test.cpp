#include "calibration/measurement_checks/gravity_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns the findings for 40 measurements of a Cobra under gravity `gravity_W`, whose cell states that gravity points
/// downwards.
MeasurementChecks checksUnder(const Eigen::Vector3d& gravity_W, bool is_base_known, std::uint64_t seed = 8) {
  PlacedArm real = cobra();
  real.arm.gravity_W = gravity_W;
  MeasurementMaker maker(real, seed, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 40);
  PlacedArm start = cobra();
  start.base_poses.front().is_known = is_base_known;
  return checkMeasurements({start, maker.measurements, {{"tool.tip"}, true}, {}});
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
    const auto* gross = firstMistake(checks);
    ASSERT_NE(gross, nullptr) << c.key;
    EXPECT_EQ(gross->name, "gravity") << gross->sentence;
    EXPECT_NE(gross->sentence.find(c.key), std::string::npos) << gross->sentence;
    EXPECT_LT(gross->error_if_corrected, gross->error_as_is / 5);
  }
}

/// Returns the gravity direction that the sentence proposes for the cell; zero if it proposes none.
Eigen::Vector3d directionIn(const std::string& sentence) {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  const std::size_t at = sentence.find("gravity: [");
  if (at != std::string::npos)
    std::sscanf(sentence.c_str() + at, "gravity: [%lf, %lf, %lf]", &direction.x(), &direction.y(), &direction.z());
  return direction;
}

Eigen::Vector3d gravityAt(double lean, double azimuth) {
  constexpr double kDegree = std::numbers::pi / 180;
  return Eigen::AngleAxisd(azimuth * kDegree, Eigen::Vector3d::UnitZ()) *
         Eigen::Vector3d(std::sin(lean * kDegree), 0, -std::cos(lean * kDegree));
}

void expectGravity(const MeasurementCheck* gross, const Eigen::Vector3d& gravity_W) {
  ASSERT_NE(gross, nullptr);
  ASSERT_EQ(gross->name, "gravity") << gross->sentence;
  EXPECT_LT(std::acos(std::min(1., directionIn(gross->sentence).normalized().dot(gravity_W))), 0.035)
      << gross->sentence;
  EXPECT_LT(gross->error_if_corrected, gross->error_as_is / 5);
}

// If gravity is oblique in the world frame, as for a base on a tilted pedestal, its direction is found to within two
// degrees.
TEST(GravityDirection, IsFoundWhereItIsOblique) {
  for (const double lean : {50., 75., 120.})
    for (const double azimuth : {0., 35., 200.}) {
      SCOPED_TRACE(testing::Message() << lean << " " << azimuth);
      const Eigen::Vector3d gravity_W = gravityAt(lean, azimuth);
      expectGravity(firstMistake(checksUnder(gravity_W, true, static_cast<std::uint64_t>(lean + azimuth))), gravity_W);
    }
}

// If the base is unknown, exchanged axes can turn it to within 45 degrees of any direction. Oblique gravity is
// nevertheless named in at least five of six cases, because it fits better.
TEST(GravityDirection, IsFoundWhereItIsObliqueAndTheBaseUnknown) {
  int named = 0;
  for (const double lean : {75., 120.})
    for (const double azimuth : {0., 35., 200.}) {
      SCOPED_TRACE(testing::Message() << lean << " " << azimuth);
      const Eigen::Vector3d gravity_W = gravityAt(lean, azimuth);
      const auto checks = checksUnder(gravity_W, false, static_cast<std::uint64_t>(lean + azimuth));
      const auto* gross = firstMistake(checks);
      ASSERT_NE(gross, nullptr);
      if (gross->name != "gravity") continue;
      ++named;
      expectGravity(gross, gravity_W);
    }
  EXPECT_GE(named, 5);
}

// If gravity is along a coordinate axis, exchanged axes explain the measurements equally well; the explanation that
// leaves the base at its nominal place is named.
TEST(GravityDirection, IsToldFromExchangedAxesByTheBase) {
  for (const Eigen::Vector3d& gravity_W :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0)}) {
    SCOPED_TRACE(testing::Message() << gravity_W.transpose());
    expectGravity(firstMistake(checksUnder(gravity_W, false)), gravity_W);
  }
  for (const char* order : {"yzx", "zxy", "x-zy", "x-y-z"}) {
    PlacedArm start = cobra();
    MeasurementMaker maker(start, 8, MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kPosition, 40);
    start.base_poses.front().is_known = false;
    const CheckedMeasurements checked{start, maker.measurements, {{"tool.tip"}, true}, {}};
    CheckedMeasurements exchanged = checked;
    findMistakeKind("axes")->correction(checked, order)->change(exchanged.measurements);
    const auto checks = checkMeasurements(exchanged);
    const auto* gross = firstMistake(checks);
    ASSERT_NE(gross, nullptr) << order;
    EXPECT_EQ(gross->name, "axes") << order << ": " << gross->sentence;
  }
}

// If gravity is tilted by 30 degrees, little more than the 26 degrees below which a tilt is left to the effect
// gravity-tilt, the checks name either its direction or no mistake at all.
TEST(GravityDirection, IsFoundOrLeftToTheFitWhereItLeansLittle) {
  for (const double azimuth : {0., 35., 200.})
    for (const bool is_base_known : {true, false}) {
      SCOPED_TRACE(testing::Message() << azimuth << " " << is_base_known);
      const Eigen::Vector3d gravity_W = gravityAt(30, azimuth);
      const auto checks = checksUnder(gravity_W, is_base_known, static_cast<std::uint64_t>(30 + azimuth));
      if (const auto* gross = firstMistake(checks)) expectGravity(gross, gravity_W);
    }
}

TEST(GravityDirection, IsLeftAloneWhereItIsRight) {
  for (const bool is_base_known : {true, false})
    for (std::uint64_t seed = 8; seed < 13; ++seed)
      EXPECT_EQ(firstMistake(checksUnder(-Eigen::Vector3d::UnitZ(), is_base_known, seed)), nullptr) << seed;
}

}  // namespace
}  // namespace tubeplan::calibration
