// Planes and spheres of unknown position: estimated from the tips that touched them, and eliminated from the fit.
#include "calibration/measurements/surfaces.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/measurement_problems.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

std::vector<MeasurementKind> kindsOfSurfaces() {
  std::vector<MeasurementKind> kinds;
  for (const auto& row : measurementKinds())
    if (row.settle) kinds.push_back(row.kind);
  return kinds;
}

std::vector<Measurement> touches(MeasurementKind kind, int count, MeasurementMaker::Noise noise,
                                 std::uint64_t seed = 3) {
  MeasurementMaker maker(cobra(), seed, noise);
  maker.add(kind, count);
  return maker.measurements;
}

/// Returns the measurements without stated values such as a sphere's radius.
std::vector<Measurement> withoutGiven(std::vector<Measurement> measurements) {
  for (auto& measurement : measurements) measurement.kind_values.setConstant(std::numeric_limits<double>::quiet_NaN());
  return measurements;
}

TEST(Surfaces, ExactMeasurementsLieOnThem) {
  for (const auto kind : kindsOfSurfaces())
    for (const auto& measurements : {touches(kind, 30, MeasurementMaker::Noise::kNone),
                                     withoutGiven(touches(kind, 30, MeasurementMaker::Noise::kNone))}) {
      const auto surfaces = surfacesOf(cobra(), measurements);
      ASSERT_EQ(surfaces.size(), 3u) << kindOf(kind).name;
      for (const auto& surface : surfaces) {
        EXPECT_EQ(surface.measurements, 10);
        EXPECT_LE(surface.rms, 1e-9) << surface.kind << " " << surface.point;
      }
    }
}

// The fitted surfaces agree with the tips from which the simulator made the touches: a plane is normal to the cross
// product of two vectors between its tips, and the centre of a sphere is at the same distance from all of its tips.
TEST(Surfaces, AreThoseThatWereTouched) {
  const PlacedArm placed = cobra();
  const auto tipsOf = [&](const std::vector<Measurement>& measurements) {
    std::vector<Eigen::Vector3d> tips;
    for (const auto& m : measurements)
      tips.push_back(toolAt(placed.arm, placed.base_poses.front().X_WB, m, kFine)->p_W);
    return tips;
  };
  const auto on_plane = touches(MeasurementKind::kPlane, 10, MeasurementMaker::Noise::kNone);
  const auto tips = tipsOf(on_plane);
  const auto plane = surfacesOf(placed, on_plane).front().surface;
  EXPECT_LE((tips[1] - tips[0]).cross(tips[2] - tips[0]).normalized().cross(plane.direction_W).norm(), 1e-6);
  const auto on_ball = touches(MeasurementKind::kSphere, 10, MeasurementMaker::Noise::kNone);
  for (const auto& measurements : {on_ball, withoutGiven(on_ball)}) {
    const auto ball = surfacesOf(placed, measurements).front().surface;
    EXPECT_NEAR(ball.radius, on_ball.front().kind_values[0], 1e-9);
    for (const auto& tip : tipsOf(on_ball)) EXPECT_NEAR((tip - ball.p_W).norm(), ball.radius, 1e-9);
  }
}

TEST(Surfaces, ResidualIsZeroAndItsSlopesAreDifferences) {
  for (const auto kind : kindsOfSurfaces()) {
    PlacedArm start = cobra();
    start.base_poses.front().is_known = false;
    const auto measurements = touches(kind, 30, MeasurementMaker::Noise::kNone);
    const auto unknowns =
        chooseUnknowns(start, {{"tool.joint_stiffness.z", "forearm.dh.a", "latch-link.joint.offset"}, true}).list;
    const auto weights = weighMeasurements(start, measurements);
    ASSERT_TRUE(weights);
    EXPECT_EQ(weights->degrees_of_freedom, 30 - 3 * 3) << "three numbers of each: the radius is stated";
    const Eigen::VectorXd zero = zerosOf(unknowns);
    const auto at = whitenedResidual(start, unknowns, measurements, *weights, zero, true);
    ASSERT_TRUE(at.ok);
    EXPECT_LE(at.error.norm(), 1e-9);
    for (Eigen::Index k = 0; k < zero.size(); ++k) {
      const double h = 1e-4 * unknowns[static_cast<std::size_t>(k)].typical;
      const auto moved = [&](double by) {
        return whitenedResidual(start, unknowns, measurements, *weights, by * Eigen::VectorXd::Unit(zero.size(), k),
                                false)
            .r.eval();
      };
      const Eigen::VectorXd slope = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
      EXPECT_LE((slope - at.jacobian.col(k)).norm(), 1e-4 * at.jacobian.col(k).norm() + 1e-6 / h)
          << kindOf(kind).name << " " << unknowns[static_cast<std::size_t>(k)].name;
    }
  }
}

// Unknown surfaces move with an unknown base, so the measurements do not determine its position.
TEST(Surfaces, DoNotSeeWhereTheBaseIs) {
  for (const auto kind : kindsOfSurfaces()) {
    PlacedArm start = cobra();
    start.base_poses.front().is_known = false;
    const auto measurements = touches(kind, 30, MeasurementMaker::Noise::kNone);
    const auto unknowns = chooseUnknowns(start, {{}, true}).list;
    const auto weights = weighMeasurements(start, measurements);
    ASSERT_TRUE(weights);
    const auto at = whitenedResidual(start, unknowns, measurements, *weights, zerosOf(unknowns), true);
    ASSERT_TRUE(at.ok);
    EXPECT_LE(at.jacobian.leftCols(3).norm(), 1e-6 * std::sqrt(30.) / measurements.front().sigma) << kindOf(kind).name;
  }
}

// If the forearm is 2 mm longer than drawn, touches of unknown surfaces reveal its length, as a tracker does.
TEST(Surfaces, TellALengthOfTheArm) {
  for (const auto kind : kindsOfSurfaces()) {
    const auto measurements = touches(kind, 90, MeasurementMaker::Noise::kStated, 11);
    PlacedArm drawing = cobra();
    double& length = deflection::locate(drawing.arm, deflection::findParameter(drawing.arm, "forearm.dh.a")->path);
    const double truth = length;
    length -= 0.002;
    IdentificationOptions options;
    options.free = {{"forearm.dh.a"}, false};
    options.folds = 0;
    options.intervals_by_profile = false;
    const auto found = identify(drawing, measurements, options);
    ASSERT_EQ(found.status, IdentificationStatus::kDone) << found.reason;
    const auto& number = found.numbers.front();
    EXPECT_NEAR(number.value, truth, 4 * number.sigma) << kindOf(kind).name;
    EXPECT_LE(number.sigma, 0.0005) << kindOf(kind).name;
    EXPECT_GT(found.p_value, 1e-3) << kindOf(kind).name;
  }
}

TEST(Surfaces, TooFewTouchesOfOneAreRefused) {
  for (const auto kind : kindsOfSurfaces()) {
    const auto measurements = touches(kind, 13, MeasurementMaker::Noise::kNone);
    ASSERT_EQ(leastOfPlace(measurements.front()), 4);
    const auto problem = findMeasurementProblem(measurements, {});
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->measurement, 10) << "three touches of the second surface";
    EXPECT_FALSE(findMeasurementProblem(touches(kind, 14, MeasurementMaker::Noise::kNone), {}));
  }
}

// The fit of a plane fails if all points are collinear, and succeeds once one point is off the line.
TEST(Surfaces, ALineOfPointsIsNoPlane) {
  const auto& plane = kindOf(MeasurementKind::kPlane);
  Eigen::Matrix3Xd points(3, 5);
  for (Eigen::Index k = 0; k < 5; ++k) points.col(k) = Eigen::Vector3d(1, 2, 3) + 0.1 * k * Eigen::Vector3d(1, 1, 0);
  Surface surface;
  EXPECT_FALSE(plane.settle(points, {}, surface));
  points(2, 4) += 0.1;
  EXPECT_TRUE(plane.settle(points, {}, surface));
}

}  // namespace
}  // namespace tubeplan::calibration
