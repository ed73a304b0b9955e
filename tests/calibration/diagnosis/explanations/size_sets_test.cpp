// Where readings do not say on which side the tip is, an effect's sizes are a set; one camera offset decides.
#include "calibration/diagnosis/explanations/size_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/measurements/steps.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"
#include "tests/calibration/synthetic_readings.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {
namespace {

/// Readings of one kind at holes of the mock-up, whose base slipped half way.
SeededSet slippedSet(const std::string& slip, MeasurementKind kind, int readings, std::uint64_t seed) {
  const auto set =
      simulatedSet("mockup.yaml", "bowl", readings, {"base-slip@base:" + slip}, seed, [&](app::SimulationTask& task) {
        task.design.kind = kind;
        task.design.place = CampaignPlace::kHoles;
        task.design.loads = {0};
        if (kindOf(kind).counts_steps) task.design.sigma = kVisitSigma;
      });
  if (!set) throw std::runtime_error("nothing was reached");
  return *set;
}

Diagnosis diagnosisOf(SeededSet set) {
  set.cell.identify = {"tool.joint_stiffness.z"};
  DiagnosisOptions options;
  options.baseline.free = app::freeNumbersOf(set.cell);
  return diagnose(app::startOf(set.cell, set.table.readings), set.table.readings, options);
}

/// The slip among the answers; null where it is in none.
const FoundEffect* slipOf(const Diagnosis& result) {
  for (const auto& explanation : result.alternatives)
    for (const auto& effect : explanation.effects)
      if (effect.effect == "base-slip") return &effect;
  return nullptr;
}

const FoundNumber& numberOf(const FoundEffect& effect, const std::string& name) {
  return *std::ranges::find(effect.numbers, name, &FoundNumber::name);
}

/// Returns whether a number holds the truth: in its range, or within its doubt; of one that does nothing, in none.
bool holds(const FoundNumber& number, double truth) {
  if (std::isfinite(number.lower)) return number.lower <= truth && truth <= number.upper;
  return std::isfinite(number.sigma) ? std::abs(number.value - truth) <= 3.5 * number.sigma : number.value == truth;
}

TEST(SizeSets, OfStepsHoldTheTruthWhicheverWayTheBaseSlipped) {
  const std::vector<std::map<std::string, double>> slips{{{"x", 0.04}}, {{"y", -0.03}}, {{"x", 0.02}, {"y", 0.02}}};
  int told = 0;
  for (const auto& slip : slips) {
    std::string text;
    for (const auto& [axis, by] : slip) text += fmt::format("{}={}in,", axis, by);
    const auto result = diagnosisOf(slippedSet(text + "time=60", MeasurementKind::kSteps, 100, 3));
    const FoundEffect* found = slipOf(result);
    if (!found) continue;  // withheld: nothing false is said
    ++told;
    for (const char* axis : {"x", "y"})
      EXPECT_TRUE(holds(numberOf(*found, axis), slip.contains(axis) ? slip.at(axis) * kInch : 0)) << text << axis;
  }
  EXPECT_GE(told, 2);
}

/// Visits whose tip is where the model has it, of which the first half took all steps and the others `steps`.
std::vector<Measurement> countsAtPredictedTips(const app::Cell& cell, int visits, double beyond, double within) {
  ReadingMaker maker({cell.arm, {{"", cell.X_WB, true}}}, 5, ReadingMaker::Noise::kNone);
  std::vector<Measurement> readings;
  for (int k = 0; k < visits; ++k) {
    Measurement visit;
    visit.id = std::to_string(k + 1);
    visit.kind = MeasurementKind::kSteps;
    visit.q = maker.drawPosture();
    visit.p_W = toolAt(cell.arm, cell.X_WB, visit)->p_W;
    visit.conditions[Condition::kTime] = 120. * k;
    const bool is_before = 2 * k < visits;
    visit.own = {is_before ? 3. : 2., is_before ? 0 : beyond, is_before ? beyond : within};
    visit.sigma = steps::sigmaBetween(visit.own[1], visit.own[2]);
    readings.push_back(visit);
  }
  return readings;
}

// A slip of any size between two tolerances, in any direction across the sheet, leaves the same counts: the answer is
// all of these, however often they were counted, and one reading of a camera decides.
TEST(SizeSets, OfEqualCountsAreARing) {
  app::Cell cell = shippedCell("mockup.yaml");
  cell.base_known = true;
  cell.identify.clear();
  const double beyond = 0.010 * kInch, within = 0.058 * kInch;
  const auto readings = countsAtPredictedTips(cell, 60, beyond, within);
  DiagnosisOptions options;
  options.baseline.free = app::freeNumbersOf(cell);
  const Diagnosis result = diagnose(app::startOf(cell, readings), readings, options);
  const FoundEffect* found = slipOf(result);
  ASSERT_TRUE(found);
  EXPECT_GE(found->modes.size(), 3U);
  for (const char* axis : {"x", "y"})
    for (const double truth : {-0.056, -0.04, -0.03, -0.012, 0.012, 0.03, 0.04, 0.056})
      EXPECT_TRUE(holds(numberOf(*found, axis), truth * kInch)) << axis << " " << truth;
  EXPECT_TRUE(std::ranges::count(found->decided_by, MeasurementKind::kOffset));
}

// Offsets that a camera sees have a sign.
TEST(SizeSets, OfOffsetsAreOne) {
  for (const auto* slip : {"x=0.04in,time=60"}) {
    const auto result = diagnosisOf(slippedSet(slip, MeasurementKind::kOffset, 60, 3));
    const FoundEffect* found = slipOf(result);
    ASSERT_TRUE(found) << slip;
    EXPECT_TRUE(found->modes.empty()) << slip;
    EXPECT_TRUE(found->decided_by.empty()) << slip;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
