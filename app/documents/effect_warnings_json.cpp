#include "app/documents/effect_warnings_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/storage/suggestion.hpp"
#include "calibration/diagnosis/causes/cause.hpp"

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

std::string warnedPlace(const EffectWarning& warning) { return warning.effect + "@" + warning.at; }

/// Returns a string such as "p = 0.4; held-out error 0.0061 with, 0.0060 in without".
std::string groundsText(const EffectWarning& warning, const Units& units) {
  const ErrorUnit unit = errorUnitOf(warning.heldout_with.are_angles, units);
  std::string text = fmt::format("p = {:.2g}", warning.p_value);
  if (std::isfinite(warning.heldout_with.rms) && std::isfinite(warning.heldout_without.rms))
    text += fmt::format("; held-out error {:.4g} with, {:.4g} {} without", warning.heldout_with.rms / unit.factor,
                        warning.heldout_without.rms / unit.factor, unit.name);
  return text;
}

std::string betterText(const EffectWarning& warning, const Units& units) {
  if (warning.better.effect != warning.effect || warning.better.at != warning.at)
    return fmt::format("{} explains these readings better than {} (by {:.0f} in BIC)",
                       calibration::causeTitle(warning.better.effect, warning.better.at), warnedPlace(warning),
                       warning.by);
  std::string values;
  for (const auto& number : warning.better.numbers)
    values += fmt::format("{}{}={:.4g}", values.empty() ? "" : ",", number.name,
                          inFile(number.value, number.quantity, units));
  return fmt::format("{}: it fits the readings better with other parameters, {} (by {:.0f} in BIC): add it with those",
                     warnedPlace(warning), values, warning.by);
}

std::string beyondText(const EffectWarning& warning, const Units& units) {
  const deflection::Quantity quantity = warning.number.quantity;
  return fmt::format("{} is {:.3g} {}, more than any real machine has ({:.3g})", warning.number.name,
                     inFile(warning.number.value, quantity, units), units.nameOf(dimensionOf(quantity)),
                     inFile(warning.plausible, quantity, units));
}

using WarningGroup = std::vector<const EffectWarning*>;

/// Returns true if both warnings fit into one sentence. A warning that the same effect fits better with other
/// parameters or at another place is stated separately.
bool fitOneSentence(const EffectWarning& a, const EffectWarning& b) {
  if (a.kind != b.kind || a.is_within_noise != b.is_within_noise) return false;
  return a.kind != EffectWarningKind::kBetterExplainedBy ||
         (a.better.effect == b.better.effect && a.better.at == b.better.at && a.better.effect != a.effect);
}

std::vector<WarningGroup> groupsOf(const std::vector<EffectWarning>& warnings) {
  std::vector<WarningGroup> groups;
  for (const EffectWarning& warning : warnings) {
    const auto group =
        std::ranges::find_if(groups, [&](const WarningGroup& g) { return fitOneSentence(*g.front(), warning); });
    if (group == groups.end())
      groups.push_back({&warning});
    else
      group->push_back(&warning);
  }
  return groups;
}

template <class TextOf>
std::string warningList(const WarningGroup& group, TextOf&& textOf) {
  std::vector<std::string> texts;
  for (const EffectWarning* warning : group) texts.push_back(textOf(*warning));
  return enumeration(texts);
}

/// Returns the range of a value over the group, such as "0.014 to 1"; a single value if both ends are printed alike.
template <class ValueOf>
std::string warningRange(const WarningGroup& group, int digits, ValueOf&& valueOf) {
  const auto [least, greatest] =
      std::ranges::minmax(group | std::views::transform([&](auto* w) { return valueOf(*w); }));
  const std::string from = fmt::format("{:.{}g}", least, digits), to = fmt::format("{:.{}g}", greatest, digits);
  return from == to ? from : from + " to " + to;
}

/// Returns the warning that effects are not needed. Each effect was tested by removing it alone. Another effect may
/// then have explained its part of the error, so only one effect may be removed at a time.
std::string notNeededText(const WarningGroup& group, const Units& units) {
  const EffectWarning& first = *group.front();
  std::string grounds = "p = " + warningRange(group, 2, [](const EffectWarning& w) { return w.p_value; });
  const bool has_heldout = std::ranges::all_of(group, [](const EffectWarning* w) {
    return std::isfinite(w->heldout_with.rms) && std::isfinite(w->heldout_without.rms);
  });
  const ErrorUnit unit = errorUnitOf(first.heldout_with.are_angles, units);
  const auto withoutOne = [&](const EffectWarning& w) { return w.heldout_without.rms / unit.factor; };
  if (has_heldout)
    grounds += fmt::format("; held-out error {:.4g} with all, {} {} without one", first.heldout_with.rms / unit.factor,
                           warningRange(group, 4, withoutOne), unit.name);
  const auto* least = *std::ranges::max_element(group, {}, [](const EffectWarning* w) { return w->p_value; });
  return fmt::format(
      "{}: the readings {} need any one of these in addition to the others ({}): remove {} and try again",
      warningList(group, warnedPlace), first.is_within_noise ? "do not" : "hardly", grounds, warnedPlace(*least));
}

std::string groupText(const WarningGroup& group, const Units& units) {
  const EffectWarning& first = *group.front();
  switch (first.kind) {
    case EffectWarningKind::kNotNeeded:
      return notNeededText(group, units);
    case EffectWarningKind::kBetterExplainedBy:
      return fmt::format("{} explains these readings better than {}",
                         calibration::causeTitle(first.better.effect, first.better.at),
                         warningList(group, [](const EffectWarning& w) {
                           return fmt::format("{} (by {:.0f} in BIC)", warnedPlace(w), w.by);
                         }));
    case EffectWarningKind::kBeyondPlausible:
      return warningList(group,
                         [&](const EffectWarning& w) { return warnedPlace(w) + " (" + beyondText(w, units) + ")"; }) +
             ": they compensate for something else";
    case EffectWarningKind::kLackOfFitRemains:
      return fmt::format(
          "{}: they do not reduce the error to the noise floor (p = {}): something else is missing, run "
          "diagnose",
          warningList(group, warnedPlace), warningRange(group, 2, [](const EffectWarning& w) { return w.p_value; }));
  }
  return "";
}

}  // namespace

std::vector<std::string> warningTexts(const std::vector<EffectWarning>& warnings, const Units& units) {
  std::vector<std::string> texts;
  for (const WarningGroup& group : groupsOf(warnings))
    texts.push_back(group.size() == 1 ? warningText(*group.front(), units) : groupText(group, units));
  return texts;
}

std::string warningText(const EffectWarning& warning, const Units& units) {
  const std::string own = warnedPlace(warning);
  switch (warning.kind) {
    case EffectWarningKind::kNotNeeded:
      return fmt::format("{}: the readings {} need it ({}): remove it", own,
                         warning.is_within_noise ? "do not" : "hardly", groundsText(warning, units));
    case EffectWarningKind::kBetterExplainedBy:
      return betterText(warning, units);
    case EffectWarningKind::kBeyondPlausible:
      return fmt::format("{}: {}: it compensates for something else", own, beyondText(warning, units));
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
      const ErrorUnit unit = errorUnitOf(warning.heldout_with.are_angles, units);
      json["heldout_rms"] = {{"with", errorJson(warning.heldout_with.rms, unit)},
                             {"without", errorJson(warning.heldout_without.rms, unit)}};
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
