// An effect that the measurements do not need must cause a warning; the effect that is truly present must not.
#include "calibration/diagnosis/effect_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "deflection/effects/formula.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::calibration {
namespace {

struct Added {
  const char* effect;
  const char* at;
};

/// The bench with effects added by hand and with the parameters of these effects freed.
struct WithEffects {
  app::Cell cell = shippedBench();
  std::vector<std::string> free = cell.identify;

  explicit WithEffects(const std::vector<Added>& added) {
    for (const auto& [effect, at] : added) add(deflection::makeEffect(cell.arm, effect, at).effect);
  }

  explicit WithEffects(const std::string& formula) { add(deflection::makeFormula(cell.arm, formula, {}).effect); }

  void add(const deflection::Effect& effect) {
    cell.arm.effects.push_back(effect);
    for (const auto& parameter : deflection::parametersOf(cell.arm))
      if (parameter.path.effect == static_cast<int>(cell.arm.effects.size()) - 1) free.push_back(parameter.name);
  }

  [[nodiscard]] std::vector<EffectWarning> identified(const std::vector<Measurement>& measurements) const {
    IdentificationOptions options;
    options.free = {free, false};
    const auto start = benchStart(cell, measurements);
    return warnOfEffects(start, measurements, options, identify(start, measurements, options));
  }

  [[nodiscard]] std::vector<EffectWarning> diagnosed(const std::vector<Measurement>& measurements) const {
    DiagnosisOptions options;
    options.baseline.free = {free, false};
    const auto start = benchStart(cell, measurements);
    return warnOfEffects(start, measurements, options, diagnose(start, measurements, options));
  }
};

std::vector<EffectWarning> ofKind(const std::vector<EffectWarning>& warnings, EffectWarningKind kind) {
  std::vector<EffectWarning> some;
  for (const auto& warning : warnings)
    if (warning.kind == kind) some.push_back(warning);
  return some;
}

TEST(EffectWarnings, TheRightEffectIsNotWarnedOf) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const WithEffects cell(std::vector<Added>{{"hysteresis", "theta3"}});
    const auto measurements = benchMeasurements(shippedBench(), "hysteresis", "theta3", {0.0006}, 60, seed);
    EXPECT_TRUE(cell.identified(measurements).empty()) << seed;
    EXPECT_TRUE(cell.diagnosed(measurements).empty()) << seed;
  }
}

TEST(EffectWarnings, AnEffectThatIsNotThereIsNotNeeded) {
  const auto measurements = benchMeasurements(shippedBench(), "", "", {}, 60, 3);
  for (const Added& wrong : {Added{"hysteresis", "theta2"}, Added{"backlash", "tool.z"}, Added{"link-twist", "forearm"},
                             Added{"gravity-tilt", "base"}}) {
    for (const auto& warnings : {WithEffects(std::vector<Added>{wrong}).identified(measurements),
                                 WithEffects(std::vector<Added>{wrong}).diagnosed(measurements)}) {
      const auto unneeded = ofKind(warnings, EffectWarningKind::kNotNeeded);
      ASSERT_EQ(unneeded.size(), 1U) << wrong.effect;
      EXPECT_EQ(unneeded.front().effect, wrong.effect);
      EXPECT_EQ(unneeded.front().at, wrong.at);
      EXPECT_GT(unneeded.front().p_value, 0.001);
      EXPECT_GT(unneeded.front().heldout_with.rms, 0.95 * unneeded.front().heldout_without.rms);
    }
  }
}

TEST(EffectWarnings, AWrongEffectInThePlaceOfTheRightOneIsToldSo) {
  const auto measurements = benchMeasurements(shippedBench(), "encoder-eccentricity", "theta3", {0.001, 0.0012}, 90, 5);
  const WithEffects cell(std::vector<Added>{{"joint-offset", "theta3"}});
  EXPECT_FALSE(ofKind(cell.identified(measurements), EffectWarningKind::kLackOfFitRemains).empty());
  const auto better = ofKind(cell.diagnosed(measurements), EffectWarningKind::kBetterExplainedBy);
  ASSERT_EQ(better.size(), 1U);
  EXPECT_EQ(better.front().effect, "joint-offset");
  EXPECT_EQ(better.front().better.effect, "encoder-eccentricity");
  EXPECT_EQ(better.front().better.at, "theta3");
  EXPECT_GT(better.front().by, 8);
}

TEST(EffectWarnings, TwoRightEffectsAreBothNeeded) {
  auto cell = shippedBench();
  auto made = deflection::makeEffect(cell.arm, "hysteresis", "theta2").effect;
  made.values = {0.0006};
  cell.arm.effects.push_back(made);
  const auto measurements = benchMeasurements(cell, "joint-offset", "theta4", {0.002}, 90, 6);
  const WithEffects both(std::vector<Added>{{"hysteresis", "theta2"}, {"joint-offset", "theta4"}});
  EXPECT_TRUE(both.identified(measurements).empty());
  EXPECT_TRUE(both.diagnosed(measurements).empty());
}

/// A diagnosis proposes no formulas, so a user's formula is judged by how much it lowers chi-square: a superfluous
/// formula must cause a warning, the correct one must not.
TEST(EffectWarnings, AFormulaOfTheUsersIsNeededWhereItIsRight) {
  const WithEffects wave("theta3 += c*sin(theta3) + d*cos(theta3)");
  const auto measurements = benchMeasurements(shippedBench(), "encoder-eccentricity", "theta3", {0.001, 0.0012}, 60, 7);
  EXPECT_TRUE(wave.identified(measurements).empty());
  EXPECT_TRUE(wave.diagnosed(measurements).empty());
  const auto nothing = benchMeasurements(shippedBench(), "", "", {}, 60, 7);
  for (const auto& warnings : {wave.identified(nothing), wave.diagnosed(nothing)}) {
    const auto unneeded = ofKind(warnings, EffectWarningKind::kNotNeeded);
    ASSERT_EQ(unneeded.size(), 1U);
    EXPECT_EQ(unneeded.front().effect, "formula");
    EXPECT_GT(unneeded.front().p_value, 0.001);
  }
}

TEST(EffectWarnings, ASizeThatNoMachineHasIsSaid) {
  const auto measurements = benchMeasurements(shippedBench(), "hysteresis", "theta3", {0.02}, 60, 2);
  const auto beyond = ofKind(WithEffects(std::vector<Added>{{"hysteresis", "theta3"}}).identified(measurements),
                             EffectWarningKind::kBeyondPlausible);
  ASSERT_EQ(beyond.size(), 1U);
  EXPECT_EQ(beyond.front().number.name, "half_width");
  EXPECT_NEAR(beyond.front().number.value, 0.02, 1e-3);
}

}  // namespace
}  // namespace tubeplan::calibration
