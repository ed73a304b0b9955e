// Readings that do not determine the free parameters are refused with a reason.
#include "calibration/measurements/reading_problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/synthetic_readings.hpp"

namespace tubeplan::calibration {
namespace {

std::vector<Unknown> unknownsOf(const std::vector<std::string>& names) {
  PlacedArm placed = cobra();
  return chooseUnknowns(placed, {names, true}).list;
}

void expectProblem(const std::vector<Measurement>& readings, const std::vector<Unknown>& unknowns,
                   const std::string& words, int reading = -1) {
  const auto problem = findReadingProblem(readings, unknowns);
  ASSERT_TRUE(problem) << "none, expected: " << words;
  EXPECT_NE(problem->what.find(words), std::string::npos) << problem->what;
  EXPECT_EQ(problem->reading, reading);
  EXPECT_FALSE(problem->advice.empty());
}

const std::vector<std::string> kTwo{"tool.joint_stiffness.z", "latch-link.beam.Iz"};

TEST(ReadingProblems, GoodReadingsHaveNone) {
  ReadingMaker maker(cobra(), 1);
  addEveryKind(maker, 2);
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf(kTwo)));
}

TEST(ReadingProblems, NoReadings) { expectProblem({}, unknownsOf(kTwo), "no reading"); }

TEST(ReadingProblems, AnUnknownPointTouchedOnceIsNamed) {
  ReadingMaker maker(cobra(), 2);
  maker.addTouches(3, {0, 100}, false);
  const Measurement lonely = maker.readings[2];
  maker.readings.erase(maker.readings.begin() + 3);
  expectProblem(maker.readings, unknownsOf(kTwo), "point " + lonely.point + ", whose position is unknown", 2);
  expectProblem(maker.readings, unknownsOf(kTwo), "(reading " + lonely.id + ")", 2);
  maker.readings[2].p_W = Eigen::Vector3d::Zero();
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf(kTwo))) << "a known point may be touched once";
}

TEST(ReadingProblems, AllAtOnePosture) {
  ReadingMaker maker(cobra(), 3);
  maker.add(MeasurementKind::kPosition, 1);
  for (int k = 0; k < 5; ++k) maker.readings.push_back(maker.readings[0]);
  expectProblem(maker.readings, unknownsOf(kTwo), "one posture");
  maker.readings[3].load += 50;
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf(kTwo))) << "another load tells something";
}

TEST(ReadingProblems, FewerNumbersThanAreFree) {
  ReadingMaker maker(cobra(), 4);
  maker.add(MeasurementKind::kDistance, 1);
  maker.addTouches(1, {0, 100}, false);
  ASSERT_EQ(maker.readings.size(), 3u);
  const auto free = unknownsOf({"tool.joint_stiffness.z", "latch-link.beam.Iz", "forearm.joint_stiffness.z",
                                "mezzanine-beam.beam.Iz", "tool.tip.x"});
  expectProblem(maker.readings, free, "4 numbers");  // one distance, and six coordinates minus three of the point
  EXPECT_NE(findReadingProblem(maker.readings, free)->what.find("5 free numbers"), std::string::npos);
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf(kTwo)));
}

// If parameters of the geometry outnumber the measured values, the readings are accepted, since only the combinations
// that they determine are fitted.
TEST(ReadingProblems, GeometryMayOutnumberTheReadings) {
  ReadingMaker maker(cobra(), 5);
  maker.add(MeasurementKind::kPosition, 3);
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf({"geometry"})));
}

}  // namespace
}  // namespace tubeplan::calibration
