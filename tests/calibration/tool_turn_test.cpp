// A small rotation of the tool frame must be fitted and diagnosed; a different convention of its axes must be
// recognised as a mistake in the data.
#include <gtest/gtest.h>

#include <algorithm>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/identification.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurement_checks/tool_frame.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

const Eigen::Vector3d kHiddenTurn = Eigen::Vector3d(0.4, -0.3, 0.0) * kDegree;

std::vector<Measurement> turnedMeasurements(const Eigen::Vector3d& turn_L, MeasurementKind kind, int count) {
  PlacedArm truth = cobra();
  truth.arm.tool_turn_L = turn_L;
  MeasurementMaker maker(truth, 5, MeasurementMaker::Noise::kStated);
  maker.add(kind, count);
  return maker.measurements;
}

TEST(ToolTurn, IsIdentifiedFromPosesWithinItsSigma) {
  const auto measurements = turnedMeasurements(kHiddenTurn, MeasurementKind::kPose, 60);
  IdentificationOptions options;
  options.free = {{"tool.turn"}, false};
  const auto found = identify(cobra().arm, cobra().base_poses[0].X_WB, true, measurements, options);
  ASSERT_EQ(found.numbers.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const auto& number = found.numbers[static_cast<std::size_t>(k)];
    EXPECT_NEAR(number.value, kHiddenTurn[k], 4 * number.sigma) << number.unknown.name;
    EXPECT_LT(number.sigma, 0.1 * kHiddenTurn.norm()) << number.unknown.name;
  }
}

TEST(ToolTurn, IsNoGeometryOfMeasurementsThatDoNotShowIt) {
  for (const auto kind : {MeasurementKind::kPosition, MeasurementKind::kPose}) {
    PlacedArm placed = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, true,
                                            turnedMeasurements(Eigen::Vector3d::Zero(), kind, 3));
    const auto free = chooseUnknowns(placed, {{"geometry"}, false}).list;
    const bool has_turn =
        std::ranges::any_of(free, [](const Unknown& unknown) { return unknown.name.starts_with("tool.turn."); });
    EXPECT_EQ(has_turn, kind == MeasurementKind::kPose);
  }
}

TEST(ToolTurn, IsNamedAloneByPoses) {
  const auto measurements = turnedMeasurements(kHiddenTurn, MeasurementKind::kPose, 90);
  DiagnosisOptions options;
  options.baseline.free = {{"tool.joint_stiffness.z"}, false};
  const auto start = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, true, measurements);
  const auto found = diagnose(start, measurements, options);
  ASSERT_EQ(found.alternatives.size(), 1U);
  ASSERT_EQ(found.alternatives[0].effects.size(), 1U);
  EXPECT_EQ(found.alternatives[0].effects[0].effect, "tool-turn");
}

TEST(ToolTurn, AnotherConventionOfTheAxesIsAMistake) {
  // The measured x axis is the tool's y axis.
  const Eigen::Matrix3d R_TM = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
  auto measurements = turnedMeasurements(Eigen::Vector3d::Zero(), MeasurementKind::kPose, 40);
  for (auto& measurement : measurements)
    measurement.kind_values =
        deflection::fixedAnglesOf(deflection::rotationFromFixedAngles<double>(measurement.kind_values) * R_TM);
  const auto start = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, true, measurements);
  const auto checks = checkMeasurements({start, measurements, {{"tool.tip"}, false}, {}});
  const auto* gross = firstMistake(checks);
  ASSERT_NE(gross, nullptr);
  EXPECT_EQ(gross->assume, "tool-frame=yzx");
}

TEST(ToolTurn, AMountedBodyIsAMistakeWithItsAngles) {
  for (const Eigen::Vector3d& rpy :
       {Eigen::Vector3d(90, 0, 35), Eigen::Vector3d(-140, 20, 15), Eigen::Vector3d(40, -6, 0)}) {
    const Eigen::Matrix3d R_TM = deflection::rotationFromFixedAngles<double>((rpy * kDegree).eval());
    auto measurements = turnedMeasurements(Eigen::Vector3d::Zero(), MeasurementKind::kPose, 40);
    for (auto& measurement : measurements)
      measurement.kind_values =
          deflection::fixedAnglesOf(deflection::rotationFromFixedAngles<double>(measurement.kind_values) * R_TM);
    const auto start = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, true, measurements);
    const CheckedMeasurements checked{start, measurements, {{"tool.tip"}, false}, {}};
    const auto checks = checkMeasurements(checked);
    const auto* gross = firstMistake(checks);
    ASSERT_NE(gross, nullptr) << rpy.transpose();
    ASSERT_EQ(gross->name, "tool-frame") << rpy.transpose();
    const auto named = mistakes::tool_frame::turnOf(checked, gross->assume.substr(gross->assume.find('=') + 1));
    ASSERT_TRUE(named);
    EXPECT_LT(mistakes::tool_frame::angleOf(named->transpose() * R_TM), 0.3 * kDegree) << gross->assume;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
