// If a mistake in the rotations under roll, pitch, yaw is combined with one in joints or coordinates, or with another
// in the rotations, both are named.
#include "calibration/measurement_checks/rotation_search.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "deflection/rotation.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

struct MistakeMade {
  std::string assume;
  std::function<void(Measurement&)> make;
};

Eigen::Matrix3d turnIn(const Measurement& m) { return deflection::rotationFromFixedAngles<double>(m.kind_values); }

const std::vector<MistakeMade>& mistakesOfTurns() {
  static const std::vector<MistakeMade> kMade{
      {"turns-as=euler-zyx", [](Measurement& m) { m.kind_values = turnIn(m).eulerAngles(2, 1, 0); }},
      {"turns-as=euler-zyz", [](Measurement& m) { m.kind_values = turnIn(m).eulerAngles(2, 1, 2); }},
      {"turns-as=rotation-vector",
       [](Measurement& m) {
         const Eigen::AngleAxisd turn(turnIn(m));
         m.kind_values = turn.angle() * turn.axis();
       }},
      {"tool-frame=yzx", [](Measurement& m) {
         Eigen::Matrix3d R_TM;  // the measured x, y, z axes are the tool's y, z, x axes
         R_TM << 0, 0, 1, 1, 0, 0, 0, 1, 0;
         m.kind_values = deflection::fixedAnglesOf(turnIn(m) * R_TM);
       }}};
  return kMade;
}

const std::vector<MistakeMade>& mistakesOfOthers() {
  static const std::vector<MistakeMade> kMade{
      {"joint-sign=theta2", [](Measurement& m) { m.q[1] *= -1; }},
      {"joint-sign=theta3", [](Measurement& m) { m.q[2] *= -1; }},
      {"joint-order=theta2:theta3", [](Measurement& m) { std::swap(m.q[1], m.q[2]); }},
      {"axes=yxz", [](Measurement& m) { std::swap((*m.p_W)[0], (*m.p_W)[1]); }}};
  return kMade;
}

MeasurementChecks checksOfPoses(const std::vector<const MistakeMade*>& made, std::uint64_t seed) {
  MeasurementMaker maker(cobra(), seed, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPose, 40);
  const auto start = placeForMeasurements(cobra().arm, cobra().base_poses[0].X_WB, seed % 2 == 0, maker.measurements);
  for (auto& measurement : maker.measurements)
    for (const auto* mistake : made) mistake->make(measurement);
  return checkMeasurements({start, maker.measurements, {{"tool.tip"}, false}, {}});
}

TEST(RotationSearch, AnotherMistakeBothAreNamed) {
  int made = 0, named = 0;
  std::string found;
  const auto& others = mistakesOfOthers();
  for (const auto& of_turns : mistakesOfTurns())
    for (std::size_t k = 0; k < others.size() / 2; ++k) {  // each mistake is combined with two of the other kind
      const auto& other = others[static_cast<std::size_t>(made) % others.size()];
      const auto checks = checksOfPoses({&of_turns, &other}, static_cast<std::uint64_t>(++made));
      const auto* gross = firstMistake(checks);
      const std::string assume = gross ? gross->assume : "nothing";
      named += assume == other.assume + "," + of_turns.assume;
      found += other.assume + " + " + of_turns.assume + ": " + assume + "\n";
    }
  EXPECT_GE(named, made - 1) << found;
}

TEST(RotationSearch, TwoOfTheTurnsAreBothNamed) {
  const auto& kinds = mistakesOfTurns();
  for (std::size_t form = 0; form < 3; ++form)
    for (const std::uint64_t seed : {1, 2}) {
      const auto checks = checksOfPoses({&kinds[3], &kinds[form]}, seed);
      const auto* gross = firstMistake(checks);
      ASSERT_NE(gross, nullptr) << kinds[form].assume;
      EXPECT_EQ(gross->assume, kinds[form].assume + "," + kinds[3].assume) << gross->sentence;
    }
}

}  // namespace
}  // namespace tubeplan::calibration
