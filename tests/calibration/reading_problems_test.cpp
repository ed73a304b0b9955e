// Readings that tell nothing are refused with a reason; slips of units are named, and not seen where there are none.
#include "calibration/reading_problems.hpp"

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
                   const std::string& found, int reading = -1) {
  const auto problem = findReadingProblem(readings, unknowns);
  ASSERT_TRUE(problem) << "none, expected: " << found;
  EXPECT_NE(problem->found.find(found), std::string::npos) << "found " << problem->found;
  EXPECT_EQ(problem->reading, reading);
  EXPECT_FALSE(problem->expected.empty());
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
  expectProblem(maker.readings, unknownsOf(kTwo), "point " + lonely.point + " (reading " + lonely.id + ")", 2);
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
  expectProblem(maker.readings, free, "4 numbers");  // one distance, and six coordinates less the three of the point
  EXPECT_NE(findReadingProblem(maker.readings, free)->expected.find("5 that are free"), std::string::npos);
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf(kTwo)));
}

// What follows from geometry alone may outnumber the readings: what they tell is kept of it.
TEST(ReadingProblems, GeometryMayOutnumberTheReadings) {
  ReadingMaker maker(cobra(), 5);
  maker.add(MeasurementKind::kPosition, 3);
  EXPECT_FALSE(findReadingProblem(maker.readings, unknownsOf({"geometry"})));
}

struct Slip {
  const char* words;
  void (*make)(Measurement&);
};

void scalePlaces(Measurement& m, double factor) {
  if (m.p_W) *m.p_W *= factor;
  m.distance *= factor;
}

// Each makes readings of what is right what the slip would have written.
constexpr Slip kSlips[] = {
    {"radians under a column in degrees", [](Measurement& m) { m.q *= kDegree; }},
    {"degrees under a column in radians", [](Measurement& m) { m.q /= kDegree; }},
    {"inches under a column in millimetres", [](Measurement& m) { scalePlaces(m, 1 / 25.4); }},
    {"millimetres under a column in inches", [](Measurement& m) { scalePlaces(m, 25.4); }},
    {"metres under a column in millimetres", [](Measurement& m) { scalePlaces(m, 1e-3); }},
    {"millimetres under a column in metres", [](Measurement& m) { scalePlaces(m, 1e3); }},
    {"a thousand times too large", [](Measurement& m) { m.load *= 1e3; }},
    {"a thousand times too small", [](Measurement& m) { m.load *= 1e-3; }},
};

/// A stiffness off by a tenth: the model as it stands is never quite right.
PlacedArm roughCobra(bool is_known) {
  PlacedArm placed = cobra();
  placed.placings[0].is_known = is_known;
  placed.arm.rows[5].joint_stiffness.z() *= 1.1;
  return placed;
}

/// The slip is named, and no more than `most` in all.
void expectSlip(const PlacedArm& placed, const std::vector<Measurement>& readings, const std::string& words,
                std::size_t most = 1) {
  const auto found = findUnitSlips(placed, readings);
  EXPECT_LE(found.size(), most);
  const auto named =
      std::find_if(found.begin(), found.end(), [&](const auto& s) { return s.what.find(words) != std::string::npos; });
  ASSERT_NE(named, found.end());
  EXPECT_LT(named->rms_if, 0.2 * named->rms_as_is);
}

TEST(UnitSlips, AreNamedWhateverTheKindOfReading) {
  const bool known = true;
  for (const Slip& slip : kSlips) {
    for (const auto kind : {MeasurementKind::kPosition, MeasurementKind::kDeflection, MeasurementKind::kDistance}) {
      ReadingMaker maker(cobra(), 7, ReadingMaker::Noise::kStated);
      maker.add(kind, 12);
      for (auto& m : maker.readings) slip.make(m);
      SCOPED_TRACE(std::string(slip.words) + ", kind " + std::to_string(static_cast<int>(kind)));
      // A thousandth of the load bends the arm like the load read in metres for millimetres.
      expectSlip(roughCobra(known), maker.readings, slip.words, kind == MeasurementKind::kDeflection ? 2 : 1);
    }
  }
}

TEST(UnitSlips, AreNamedWhereTheBaseIsNotKnownEither) {
  for (const Slip& slip : kSlips) {
    ReadingMaker maker(cobra(), 8, ReadingMaker::Noise::kStated);
    maker.add(MeasurementKind::kPosition, 12);
    for (auto& m : maker.readings) slip.make(m);
    SCOPED_TRACE(slip.words);
    expectSlip(roughCobra(false), maker.readings, slip.words);
  }
}

TEST(UnitSlips, AreNotSeenInCleanReadings) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    ReadingMaker maker(cobra(), seed, ReadingMaker::Noise::kStated);
    addEveryKind(maker, 2);
    EXPECT_TRUE(findUnitSlips(roughCobra(seed % 2 == 0), maker.readings).empty()) << seed;
  }
}

TEST(UnitSlips, AModelThatIsFarOffIsNoSlip) {
  PlacedArm placed = cobra();
  for (auto& row : placed.arm.rows) row.joint_stiffness /= 3;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ReadingMaker maker(cobra(), seed, ReadingMaker::Noise::kStated);
    addEveryKind(maker, 2);
    EXPECT_TRUE(findUnitSlips(placed, maker.readings).empty()) << seed;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
