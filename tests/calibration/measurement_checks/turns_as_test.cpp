// If the columns roll, pitch, yaw contain rotations in another form, the checks name the form, and their correction
// restores the rotations. The test writes the forms with code that is independent of the reader's.
#include "calibration/measurement_checks/turns_as.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using WriteTurn = std::function<Eigen::Vector3d(const Eigen::Matrix3d&)>;

const std::map<std::string, WriteTurn>& turnWriters() {
  static const std::map<std::string, WriteTurn> kWriters{
      {"euler-zyx", [](const Eigen::Matrix3d& R) { return R.eulerAngles(2, 1, 0); }},
      {"euler-xyz", [](const Eigen::Matrix3d& R) { return R.eulerAngles(0, 1, 2); }},
      {"euler-zyz", [](const Eigen::Matrix3d& R) { return R.eulerAngles(2, 1, 2); }},
      {"rotation-vector", [](const Eigen::Matrix3d& R) -> Eigen::Vector3d {
         const Eigen::AngleAxisd turn(R);
         return turn.angle() * turn.axis();
       }}};
  return kWriters;
}

struct Turned {
  PlacedArm start;
  std::vector<Measurement> clean, measurements;
};

Turned turnedIn(const WriteTurn& write, MeasurementKind kind, int count, std::uint64_t seed, bool is_base_known) {
  MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
  maker.add(kind, count);
  Turned turned{placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, is_base_known, maker.measurements),
                maker.measurements, maker.measurements};
  for (auto& measurement : turned.measurements)
    measurement.kind_values = write(deflection::rotationFromFixedAngles<double>(measurement.kind_values));
  return turned;
}

CheckedMeasurements checkedTurns(const Turned& turned) {
  return {turned.start, turned.measurements, {{"tool.tip"}, false}, {}};
}

TEST(TurnsAs, EveryFormIsATurnOfTheTable) {
  const auto turned = turnedIn(turnWriters().at("euler-zyx"), MeasurementKind::kPose, 3, 1, true);
  auto names = mistakes::turns_as::values(checkedTurns(turned));
  std::ranges::sort(names);
  std::vector<std::string> written;
  for (const auto& [name, write] : turnWriters()) written.push_back(name);
  EXPECT_EQ(names, written);
  for (const char* value : {"", "zyz", "fixed-angles", "quaternion", "euler-zyz:theta1"})
    EXPECT_FALSE(mistakes::turns_as::correction(checkedTurns(turned), value)) << value;
}

TEST(TurnsAs, IsNamedAndCorrectedOfEveryForm) {
  for (const auto& [name, write] : turnWriters())
    for (const auto kind : {MeasurementKind::kPose, MeasurementKind::kOrientation})
      for (const std::uint64_t seed : {1, 2, 3})
        for (const bool is_base_known : {true, false}) {
          if (kind == MeasurementKind::kOrientation && !is_base_known) continue;  // rotations do not determine a base
          const auto turned = turnedIn(write, kind, seed == 3 ? 12 : 40, seed, is_base_known);
          const auto checked = checkedTurns(turned);
          const auto checks = checkMeasurements(checked);
          const auto* gross = firstMistake(checks);
          const std::string label = fmt::format("{} kind {} seed {} base {}", name, static_cast<int>(kind), seed,
                                                is_base_known ? "known" : "unknown");
          ASSERT_NE(gross, nullptr) << label;
          EXPECT_EQ(gross->assume, "turns-as=" + name) << label << ": " << gross->sentence;
          auto corrected = turned.measurements;
          mistakes::turns_as::correction(checked, name)->apply(corrected);
          for (std::size_t k = 0; k < corrected.size(); ++k)
            EXPECT_TRUE(deflection::rotationFromFixedAngles<double>(corrected[k].kind_values)
                            .isApprox(deflection::rotationFromFixedAngles<double>(turned.clean[k].kind_values), 1e-9))
                << label;
        }
}

TEST(TurnsAs, IsNotSeenInTurnsThatAreRight) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
    maker.add(MeasurementKind::kPose, 30);
    const auto start = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, false, maker.measurements);
    const auto checks = checkMeasurements({start, maker.measurements, {{"tool.tip"}, false}, {}});
    EXPECT_EQ(firstMistake(checks), nullptr) << seed;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
