// Measurements that do not determine the free parameters are refused with a reason.
#include "calibration/measurements/measurement_problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

std::vector<Unknown> unknownsOf(const std::vector<std::string>& names) {
  PlacedArm placed = cobra();
  return chooseUnknowns(placed, {names, true}).list;
}

void expectProblem(const std::vector<Measurement>& measurements, const std::vector<Unknown>& unknowns,
                   const std::string& words, int measurement = -1) {
  const auto problem = findMeasurementProblem(measurements, unknowns);
  ASSERT_TRUE(problem) << "none, expected: " << words;
  EXPECT_NE(problem->what.find(words), std::string::npos) << problem->what;
  EXPECT_EQ(problem->measurement, measurement);
  EXPECT_FALSE(problem->advice.empty());
}

const std::vector<std::string> kTwo{"tool.joint_stiffness.z", "latch-link.beam.Iz"};

TEST(MeasurementProblems, GoodMeasurementsHaveNone) {
  MeasurementMaker maker(cobra(), 1);
  addEveryKind(maker, 2);
  EXPECT_FALSE(findMeasurementProblem(maker.measurements, unknownsOf(kTwo)));
}

TEST(MeasurementProblems, NoMeasurements) { expectProblem({}, unknownsOf(kTwo), "no reading"); }

TEST(MeasurementProblems, AnUnknownPointTouchedOnceIsNamed) {
  MeasurementMaker maker(cobra(), 2);
  maker.addTouches(3, {0, 100}, false);
  const Measurement lonely = maker.measurements[2];
  maker.measurements.erase(maker.measurements.begin() + 3);
  expectProblem(maker.measurements, unknownsOf(kTwo), "point " + lonely.point + ", whose position is unknown", 2);
  expectProblem(maker.measurements, unknownsOf(kTwo), "(reading " + lonely.id + ")", 2);
  maker.measurements[2].p_W = Eigen::Vector3d::Zero();
  EXPECT_FALSE(findMeasurementProblem(maker.measurements, unknownsOf(kTwo))) << "a known point may be touched once";
}

TEST(MeasurementProblems, AllAtOnePosture) {
  MeasurementMaker maker(cobra(), 3);
  maker.add(MeasurementKind::kPosition, 1);
  for (int k = 0; k < 5; ++k) maker.measurements.push_back(maker.measurements[0]);
  expectProblem(maker.measurements, unknownsOf(kTwo), "one posture");
  maker.measurements[3].load += 50;
  EXPECT_FALSE(findMeasurementProblem(maker.measurements, unknownsOf(kTwo))) << "another load tells something";
}

TEST(MeasurementProblems, FewerNumbersThanAreFree) {
  MeasurementMaker maker(cobra(), 4);
  maker.add(MeasurementKind::kDistance, 1);
  maker.addTouches(1, {0, 100}, false);
  ASSERT_EQ(maker.measurements.size(), 3u);
  const auto free = unknownsOf({"tool.joint_stiffness.z", "latch-link.beam.Iz", "forearm.joint_stiffness.z",
                                "mezzanine-beam.beam.Iz", "tool.tip.x"});
  expectProblem(maker.measurements, free, "4 numbers");  // one distance, and six coordinates minus three of the point
  EXPECT_NE(findMeasurementProblem(maker.measurements, free)->what.find("5 free numbers"), std::string::npos);
  EXPECT_FALSE(findMeasurementProblem(maker.measurements, unknownsOf(kTwo)));
}

// If parameters of the geometry outnumber the measured values, the measurements are accepted, because only the
// combinations that they determine are fitted.
TEST(MeasurementProblems, GeometryMayOutnumberTheMeasurements) {
  MeasurementMaker maker(cobra(), 5);
  maker.add(MeasurementKind::kPosition, 3);
  EXPECT_FALSE(findMeasurementProblem(maker.measurements, unknownsOf({"geometry"})));
}

}  // namespace
}  // namespace tubeplan::calibration
