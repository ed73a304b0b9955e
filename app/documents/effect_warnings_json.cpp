#include "app/documents/effect_warnings_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"

namespace tubeplan::app {

namespace {

using calibration::EffectWarning, calibration::EffectWarningKind;

const char* warningName(EffectWarningKind kind) {
  switch (kind) {
    case EffectWarningKind::kNotNeeded:
      return "not-needed";
    case EffectWarningKind::kBetterExplainedBy:
      return "better-explained-by";
    case EffectWarningKind::kBeyondPlausible:
      return "beyond-plausible";
    case EffectWarningKind::kLackOfFitRemains:
      return "misfit-remains";
  }
  return "";
}

double inFile(double value, deflection::Quantity quantity, const Units& units) {
  return value / units.factor(dimensionOf(quantity));
}

/// "(p = 0.4; held-out error 0.0061 in with, 0.0060 in without)".
std::string groundsText(const EffectWarning& warning, const Units& units) {
  std::string text = fmt::format("p = {:.2g}", warning.p_value);
  if (std::isfinite(warning.heldout_with.rms) && std::isfinite(warning.heldout_without.rms))
    text += fmt::format("; held-out error {:.4g} with, {:.4g} {} without",
                        warning.heldout_with.rms / units.factor(dimension::kLength),
                        warning.heldout_without.rms / units.factor(dimension::kLength), units.length().name);
  return text;
}

std::string betterText(const EffectWarning& warning, const Units& units) {
  const std::string better = warning.better.effect + "@" + warning.better.at;
  const std::string own = warning.effect + "@" + warning.at;
  if (better != own)
    return fmt::format("{} explains these readings better than {} (by {:.0f} in BIC)", better, own, warning.by);
  std::string values;
  for (const auto& number : warning.better.numbers)
    values += fmt::format("{}{}={:.4g}", values.empty() ? "" : ",", number.name,
                          inFile(number.value, number.quantity, units));
  return fmt::format("{}: it fits the readings better with other parameters, {} (by {:.0f} in BIC): add it with those",
                     own, values, warning.by);
}

}  // namespace

std::string warningText(const EffectWarning& warning, const Units& units) {
  const std::string own = warning.effect + "@" + warning.at;
  switch (warning.kind) {
    case EffectWarningKind::kNotNeeded:
      return fmt::format("{}: the readings {} need it ({}): take it out", own,
                         warning.is_within_noise ? "do not" : "hardly", groundsText(warning, units));
    case EffectWarningKind::kBetterExplainedBy:
      return betterText(warning, units);
    case EffectWarningKind::kBeyondPlausible:
      return fmt::format(
          "{}: {} is {:.3g} {}, more than any real machine has ({:.3g}): it compensates for something else", own,
          warning.number.name, inFile(warning.number.value, warning.number.quantity, units),
          units.nameOf(dimensionOf(warning.number.quantity)),
          inFile(warning.plausible, warning.number.quantity, units));
    case EffectWarningKind::kLackOfFitRemains:
      return fmt::format(
          "{}: it does not reduce the error to the noise floor (p = {:.2g}): something else is missing, run diagnose",
          own, warning.p_value);
  }
  return "";
}

nlohmann::json effectWarningsJson(const std::vector<EffectWarning>& warnings, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& warning : warnings) {
    nlohmann::json json = {{"effect", warning.effect},
                           {"at", warning.at},
                           {"kind", warningName(warning.kind)},
                           {"sentence", warningText(warning, units)}};
    if (std::isfinite(warning.p_value)) json["p_value"] = finiteJson(warning.p_value);
    if (warning.kind == EffectWarningKind::kNotNeeded) {
      json["chi2_fall"] = finiteJson(warning.fall);
      json["within_noise"] = warning.is_within_noise;
      json["at_neutral"] = warning.is_at_neutral;
      json["heldout_rms"] = {{"with", finiteJson(warning.heldout_with.rms / units.factor(dimension::kLength))},
                             {"without", finiteJson(warning.heldout_without.rms / units.factor(dimension::kLength))}};
    }
    if (warning.kind == EffectWarningKind::kBetterExplainedBy) {
      json["better"] = {{"effect", warning.better.effect}, {"at", warning.better.at}};
      json["criterion_gap"] = finiteJson(warning.by);
    }
    if (warning.kind == EffectWarningKind::kBeyondPlausible)
      json["number"] = {{"name", warning.number.name},
                        {"value", finiteJson(inFile(warning.number.value, warning.number.quantity, units))},
                        {"plausible", finiteJson(inFile(warning.plausible, warning.number.quantity, units))},
                        {"unit", units.nameOf(dimensionOf(warning.number.quantity))}};
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace tubeplan::app
