// Warnings of the same kind about several effects of a cell are stated in one sentence that names all of them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/documents/effect_warnings_json.hpp"
#include "app/formats/yaml/strict_yaml.hpp"

namespace tubeplan::app {
namespace {

using calibration::EffectWarning, calibration::EffectWarningKind;

Units metricUnits() {
  return Units(
      parseYaml("units: {length: mm, angle: deg, force: N, temperature: degC, time: s}\n", "f.yaml").at("units"));
}

EffectWarning warningOf(EffectWarningKind kind, const std::string& at, double p_value) {
  EffectWarning warning;
  warning.kind = kind;
  warning.effect = "joint-compliance";
  warning.at = at;
  warning.p_value = p_value;
  warning.is_within_noise = kind == EffectWarningKind::kNotNeeded;
  warning.by = 10;
  warning.better.effect = "backlash";
  warning.better.at = "tool.z";
  return warning;
}

const std::vector<std::string> kPlaces{"link.x", "link.y", "tool.x", "tool.y", "wrist.x", "wrist.y", "wrist.z"};

std::vector<EffectWarning> ofAllPlaces(EffectWarningKind kind) {
  std::vector<EffectWarning> warnings;
  for (std::size_t k = 0; k < kPlaces.size(); ++k)
    warnings.push_back(warningOf(kind, kPlaces[k], 0.1 * static_cast<double>(k)));
  return warnings;
}

TEST(EffectWarningTexts, SayEveryKindOnceAndNameAllItsMembers) {
  std::vector<EffectWarning> all;
  for (const auto kind : {EffectWarningKind::kNotNeeded, EffectWarningKind::kBetterExplainedBy,
                          EffectWarningKind::kBeyondPlausible, EffectWarningKind::kLackOfFitRemains}) {
    const auto warnings = ofAllPlaces(kind);
    all.insert(all.end(), warnings.begin(), warnings.end());
    const auto texts = warningTexts(warnings, metricUnits());
    ASSERT_EQ(texts.size(), 1u) << static_cast<int>(kind);
    for (const auto& place : kPlaces) EXPECT_NE(texts[0].find("joint-compliance@" + place), std::string::npos) << place;
  }
  EXPECT_EQ(warningTexts(all, metricUnits()).size(), 4u);
  EXPECT_EQ(effectWarningsJson(all, metricUnits()).size(), all.size());
}

TEST(EffectWarningTexts, AskForTheLeastNeededToBeTakenOutFirst) {
  const auto texts = warningTexts(ofAllPlaces(EffectWarningKind::kNotNeeded), metricUnits());
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_NE(texts[0].find("p = 0 to 0.6"), std::string::npos) << texts[0];
  EXPECT_NE(texts[0].find("remove joint-compliance@wrist.z and"), std::string::npos) << texts[0];
}

TEST(EffectWarningTexts, KeepApartWhatDiffers) {
  auto hardly = warningOf(EffectWarningKind::kNotNeeded, "link.x", 0.01);
  hardly.is_within_noise = false;
  auto other_cause = warningOf(EffectWarningKind::kBetterExplainedBy, "link.y", 0.01);
  other_cause.better.at = "wrist.z";
  const std::vector<EffectWarning> warnings{warningOf(EffectWarningKind::kNotNeeded, "tool.x", 0.5), hardly,
                                            warningOf(EffectWarningKind::kBetterExplainedBy, "tool.y", 0.01),
                                            other_cause};
  const auto texts = warningTexts(warnings, metricUnits());
  ASSERT_EQ(texts.size(), warnings.size());
  for (std::size_t k = 0; k < texts.size(); ++k) EXPECT_EQ(texts[k], warningText(warnings[k], metricUnits()));
}

}  // namespace
}  // namespace tubeplan::app
