// The diagnosis must report several sets of values for an effect if the measurements do not show the direction of the
// tip's offset, and one set if they do.
#include "calibration/diagnosis/explanations/size_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/measurements/steps.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"
#include "tests/calibration/synthetic_measurements.hpp"
#include "tests/units.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns measurements of one kind at holes of the mock-up; the base slips midway.
SeededSet slippedSet(const std::string& slip, MeasurementKind kind, int measurements, std::uint64_t seed) {
  const auto set = simulatedSet("mockup.yaml", "bowl", measurements, {"base-slip@base:" + slip}, seed,
                                [&](app::SimulationTask& task) {
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
  return diagnose(app::startOf(set.cell, set.table.measurements), set.table.measurements, options);
}

/// Returns the base slip among the explanations; null if no explanation contains one.
const FoundEffect* slipOf(const Diagnosis& result) {
  for (const auto& explanation : result.alternatives)
    for (const auto& effect : explanation.effects)
      if (effect.effect == "base-slip") return &effect;
  return nullptr;
}

const FoundNumber& numberOf(const FoundEffect& effect, const std::string& name) {
  return *std::ranges::find(effect.numbers, name, &FoundNumber::name);
}

/// Returns true if a parameter agrees with the truth: within its range, else within 3.5 standard deviations, else
/// (without a standard deviation) exactly.
bool holds(const FoundNumber& number, double truth) {
  if (std::isfinite(number.lower)) return number.lower <= truth && truth <= number.upper;
  return std::isfinite(number.sigma) ? std::abs(number.value - truth) <= 3.5 * number.sigma : number.value == truth;
}

TEST(SizeSets, OfStepsHoldTheTruthWhicheverWayTheBaseSlipped) {
  const std::vector<std::map<std::string, double>> slips{{{"x", 0.04}}, {{"y", -0.03}}, {{"x", 0.02}, {"y", 0.02}}};
  int named = 0;
  for (const auto& slip : slips) {
    std::string text;
    for (const auto& [axis, by] : slip) text += fmt::format("{}={}in,", axis, by);
    const auto result = diagnosisOf(slippedSet(text + "time=60", MeasurementKind::kSteps, 100, 3));
    const FoundEffect* found = slipOf(result);
    if (!found) continue;  // an effect that is not named is not a wrong answer
    ++named;
    for (const char* axis : {"x", "y"})
      EXPECT_TRUE(holds(numberOf(*found, axis), slip.contains(axis) ? slip.at(axis) * kInch : 0)) << text << axis;
  }
  EXPECT_GE(named, 2);
}

/// Returns visits to holes at the predicted tip positions: all steps of the tool enter in the first half of the visits,
/// two of three steps in the second half.
std::vector<Measurement> countsAtPredictedTips(const app::Cell& cell, int visits, double beyond, double within) {
  MeasurementMaker maker({cell.arm, {{"", cell.X_WB, true}}}, 5, MeasurementMaker::Noise::kNone);
  std::vector<Measurement> measurements;
  for (int k = 0; k < visits; ++k) {
    Measurement visit;
    visit.id = std::to_string(k + 1);
    visit.kind = MeasurementKind::kSteps;
    visit.q = maker.drawPosture();
    visit.p_W = toolAt(cell.arm, cell.X_WB, visit)->p_W;
    visit.conditions[Condition::kTime] = 120. * k;
    const bool is_before = 2 * k < visits;
    visit.kind_values = {is_before ? 3. : 2., is_before ? 0 : beyond, is_before ? beyond : within};
    visit.sigma = steps::sigmaBetween(visit.kind_values[1], visit.kind_values[2]);
    measurements.push_back(visit);
  }
  return measurements;
}

// All slips whose length is between two tolerances give the same step counts, regardless of their horizontal direction.
// The diagnosis must report the range of all these slips, and that the offset in a camera image would decide between
// them.
TEST(SizeSets, OfEqualCountsAreARing) {
  app::Cell cell = shippedCell("mockup.yaml");
  cell.base_known = true;
  cell.identify.clear();
  const double beyond = 0.010 * kInch, within = 0.058 * kInch;
  const auto measurements = countsAtPredictedTips(cell, 60, beyond, within);
  DiagnosisOptions options;
  options.baseline.free = app::freeNumbersOf(cell);
  const Diagnosis result = diagnose(app::startOf(cell, measurements), measurements, options);
  const FoundEffect* found = slipOf(result);
  ASSERT_TRUE(found);
  EXPECT_GE(found->modes.size(), 3U);
  for (const char* axis : {"x", "y"})
    for (const double truth : {-0.056, -0.04, -0.03, -0.012, 0.012, 0.03, 0.04, 0.056})
      EXPECT_TRUE(holds(numberOf(*found, axis), truth * kInch)) << axis << " " << truth;
  EXPECT_TRUE(std::ranges::count(found->decided_by, MeasurementKind::kOffset));
}

// Offsets in a camera image show the direction of a slip, so the diagnosis must report a single set of values for it.
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
