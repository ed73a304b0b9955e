#include "deflection/effects/signature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

using Kind = EffectVariable;

constexpr double kThirtyPounds = 30 * 4.4482216152605;

Signature signatureAt(const std::string& name, const std::string& at) {
  const Arm arm = cobraArm();
  const auto made = makeEffect(arm, name, at);
  EXPECT_EQ(made.status, EffectStatus::kMade) << name << "@" << at;
  return signatureOf(arm, made.effect, -Eigen::Vector3d::UnitZ(), {.most_load = kThirtyPounds});
}

double span(const std::vector<double>& values) {
  double low = 1e300, high = -1e300;
  for (const double value : values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return high - low;
}

TEST(Signature, IsAgainstWhatTheLawFollows) {
  struct Row {
    const char *name, *at;
    Kind kind;
    int joint;
  };
  const Row rows[] = {
      {"hysteresis", "theta4", Kind::kDirection, 3},       {"hysteresis", "theta2", Kind::kDirection, 1},
      {"encoder-eccentricity", "theta3", Kind::kJoint, 2}, {"transmission-error", "theta2", Kind::kJoint, 1},
      {"joint-scale", "theta3", Kind::kJoint, 2},          {"thermal-growth", "arm", Condition::kTemperature, -1},
      {"base-drift", "base", Condition::kTime, -1},        {"base-slip", "base", Condition::kTime, -1}};
  for (const auto& [name, at, kind, joint] : rows) {
    const Signature found = signatureAt(name, at);
    EXPECT_EQ(found.kind, kind) << name << "@" << at;
    EXPECT_EQ(found.joint, joint) << name << "@" << at;
    EXPECT_GT(span(found.shift), 1e-6) << name << "@" << at;
    EXPECT_EQ(found.shift.size(), found.at.size());
  }
}

TEST(Signature, HysteresisHasTwoLevelsAndASlipAStep) {
  const Signature two = signatureAt("hysteresis", "theta4");
  ASSERT_EQ(two.at, (std::vector<double>{-1, 1}));
  EXPECT_NEAR(two.shift[0], -two.shift[1], 0.01 * std::abs(two.shift[1]));
  const Signature step = signatureAt("base-slip", "base");
  const double before = step.shift.front(), after = step.shift.back();
  EXPECT_NEAR(before, 0, 1e-9);
  for (std::size_t k = 0; k < step.at.size(); ++k)
    EXPECT_NEAR(step.shift[k], step.at[k] < 2 * 3600 ? before : after, 1e-9) << k;
}

TEST(Signature, EveryEffectThatMovesTheTipOfTheCobraHasOne) {
  const Arm arm = cobraArm();
  for (const EffectKind& kind : effectKinds()) {
    if (kind.parameters.empty() || kind.stage == EffectStage::kMeasurement || kind.at == PlaceRule::kSetup ||
        kind.needs.tool_turn)
      continue;
    const auto places = placeTexts(arm, kind);
    const bool has_any = std::any_of(places.begin(), places.end(),
                                     [&](const auto& at) { return signatureAt(kind.name, at).kind != std::nullopt; });
    EXPECT_TRUE(has_any || places.empty()) << kind.name;
  }
}

}  // namespace
}  // namespace tubeplan::deflection
