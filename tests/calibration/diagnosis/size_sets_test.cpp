// Where readings do not say on which side the tip is, an effect's sizes are a set; one camera offset decides.
#include "calibration/diagnosis/size_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/calibration/measurement_checks/seeded_sets.hpp"

namespace tubeplan::calibration {
namespace {

/// Readings of one kind at holes of the mock-up, whose base slipped half way.
SeededSet slippedSet(const std::string& slip, MeasurementKind kind, int readings, std::uint64_t seed) {
  const auto set = simulatedSet("mockup.yaml", "bowl", readings, {"base-slip@base:" + slip}, seed,
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

// The same steps went in whether the base slipped along x or along y.
TEST(SizeSets, OfStepsHoldTheTruthWhicheverWayItSlipped) {
  const std::vector<std::map<std::string, double>> slips{
      {{"x", 0.04}}, {{"x", -0.04}}, {{"y", 0.03}}, {{"y", -0.03}}, {{"x", 0.02}, {"y", 0.02}}};
  for (const auto& slip : slips) {
    std::string text;
    for (const auto& [axis, by] : slip) text += fmt::format("{}={}in,", axis, by);
    const auto result = diagnosisOf(slippedSet(text + "time=60", MeasurementKind::kSteps, 100, 3));
    const FoundEffect* found = slipOf(result);
    if (!found) continue;  // withheld: nothing false is said
    for (const char* axis : {"x", "y"}) {
      const FoundNumber& number = numberOf(*found, axis);
      const double truth = slip.contains(axis) ? slip.at(axis) * kInch : 0;
      if (found->modes.empty()) {
        EXPECT_NEAR(number.value, truth, 3.5 * number.sigma) << text << axis;
      } else {
        EXPECT_LE(number.lower, truth) << text << axis;
        EXPECT_GE(number.upper, truth) << text << axis;
      }
    }
  }
}

// Offsets that a camera sees have a sign.
TEST(SizeSets, OfOffsetsAreOne) {
  for (const auto* slip : {"x=0.04in,time=60", "y=0.03in,time=60"}) {
    const auto result = diagnosisOf(slippedSet(slip, MeasurementKind::kOffset, 100, 3));
    const FoundEffect* found = slipOf(result);
    ASSERT_TRUE(found) << slip;
    EXPECT_TRUE(found->modes.empty()) << slip;
    EXPECT_TRUE(found->decided_by.empty()) << slip;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
