#include "app/diagnosis_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command_inputs.hpp"
#include "app/diagnosis_views_json.hpp"
#include "app/figures.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::FoundEffect, calibration::FoundNumber,
    calibration::Measurement, calibration::RankedEffect, calibration::Verdict;

nlohmann::json numberJson(const FoundNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  return {{"name", number.name},
          {"value", finiteJson(number.value / units.factor(unit))},
          {"sigma", finiteJson(number.sigma / units.factor(unit))},
          {"unit", units.nameOf(unit)}};
}

nlohmann::json effectJson(const FoundEffect& effect, const Units& units) {
  nlohmann::json parameters = nlohmann::json::object();
  for (const auto& number : effect.numbers) {
    parameters[number.name] = numberJson(number, units);
    if (number.is_beyond_usual) parameters[number.name]["beyond_usual"] = true;
    parameters[number.name].erase("name");
  }
  nlohmann::json also = nlohmann::json::array();
  for (const auto& [name, at] : effect.also) also.push_back({{"effect", name}, {"at", at}});
  nlohmann::json json = {{"effect", effect.effect}, {"at", effect.at}, {"parameters", parameters}, {"also", also}};
  if (!effect.frees.empty()) json["frees"] = effect.frees;
  return json;
}

nlohmann::json rankedJson(const RankedEffect& entry, const Units& units) {
  return {{"effect", entry.effect},
          {"at", entry.at},
          {"probability", finiteJson(entry.probability)},
          {"p_value", finiteJson(entry.p_value)},
          {"chi2_fall", finiteJson(entry.fall)},
          {"size", numberJson(entry.size, units)},
          {"kept_fraction", finiteJson(entry.kept_fraction)},
          {"heldout_rms",
           {{"before", lengthJson(entry.heldout_before.rms, units)},
            {"after", lengthJson(entry.heldout_after.rms, units)}}}};
}

std::string numberText(const FoundNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  const std::string name = units.nameOf(unit) == "1" ? "" : " " + units.nameOf(unit);
  if (std::isnan(number.sigma)) return fmt::format("{} {:.3g}{}", number.name, number.value / units.factor(unit), name);
  return fmt::format("{} {:.3g} ± {:.2g}{}", number.name, number.value / units.factor(unit),
                     number.sigma / units.factor(unit), name);
}

std::string effectText(const FoundEffect& effect, const Units& units) {
  std::vector<std::string> numbers;
  for (const auto& number : effect.numbers)
    if (std::isfinite(number.sigma) || number.quantity == deflection::Quantity::kTime)
      numbers.push_back(numberText(number, units));
  return fmt::format("{}@{} ({})", effect.effect, effect.at, fmt::join(numbers, ", "));
}

std::string explanationText(const Explanation& explanation, const Units& units) {
  std::vector<std::string> effects;
  for (const auto& effect : explanation.effects) effects.push_back(effectText(effect, units));
  return fmt::format("{}", fmt::join(effects, " with "));
}

std::string namesText(const Explanation& explanation) {
  std::vector<std::string> names;
  for (const auto& effect : explanation.effects) names.push_back(effect.effect + "@" + effect.at);
  return fmt::format("{}", fmt::join(names, " with "));
}

std::string followsText(const calibration::Remainder& remainder) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < remainder.follows.size() && k < 2; ++k) names.push_back(remainder.follows[k].first);
  return names.empty() ? "" : fmt::format(", mostly with {}", fmt::join(names, " and "));
}

std::string remainderText(const Diagnosis& result, const Units& units) {
  const auto& remainder = result.remainder;
  if (!std::isfinite(remainder.size)) return "";
  return fmt::format("{} remains that no known effect explains{}", lengthText(remainder.size, units),
                     followsText(remainder));
}

std::string unexplainedSentence(const Diagnosis& result, const Units& units) {
  const std::string rest = remainderText(result, units);
  return fmt::format("Something is missing, and no known effect is sure to be part of it{}.",
                     rest.empty() ? "" : ": " + rest);
}

std::string inconclusiveSentence(const Diagnosis& result) {
  if (!result.reason.empty()) return "No verdict is possible: " + result.reason + ".";
  return fmt::format("The readings hint at something missing (probability {:.0f} %), but not enough to say what.",
                     100 * (1 - result.nothing_probability));
}

/// The explanations that are shown, with what they leave.
nlohmann::json explanationsJson(const Diagnosis& result, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& explanation : calibration::explanationsShown(result)) {
    nlohmann::json effects = nlohmann::json::array();
    for (const auto& effect : explanation.effects) effects.push_back(effectJson(effect, units));
    list.push_back({{"effects", effects},
                    {"chi2", finiteJson(explanation.chi2)},
                    {"probability", finiteJson(explanation.probability)},
                    {"p_value", finiteJson(explanation.p_value)},
                    {"rms", lengthJson(explanation.after.rms, units)},
                    {"heldout_rms", lengthJson(explanation.heldout.rms, units)},
                    {"enough", !result.alternatives.empty()}});
  }
  return list;
}

}  // namespace

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNotRun:
      return "not-run";
    case Verdict::kAdequate:
      return "adequate";
    case Verdict::kExplained:
      return "explained";
    case Verdict::kPartlyExplained:
      return "partly-explained";
    case Verdict::kAmbiguous:
      return "ambiguous";
    case Verdict::kUnexplained:
      return "unexplained";
    case Verdict::kInconclusive:
      return "inconclusive";
    case Verdict::kStopped:
      return "stopped";
  }
  return "";
}

std::string diagnosisSentence(const Diagnosis& result, const Units& units) {
  std::vector<std::string> names;
  for (const auto& alternative : result.alternatives) names.push_back(explanationText(alternative, units));
  switch (result.verdict) {
    case Verdict::kNotRun:
    case Verdict::kStopped:
      return "Not diagnosed: " + result.reason + ".";
    case Verdict::kAdequate:
      return fmt::format("Nothing is missing: the error of {} is what noise leaves ({}).",
                         lengthText(result.before.rms, units), lengthText(result.noise_floor, units));
    case Verdict::kExplained:
      return fmt::format("Missing: {}. With it the held-out error falls from {} to {}; noise alone leaves {}.",
                         names.front(), lengthText(result.heldout_before.rms, units),
                         lengthText(result.heldout_after.rms, units), lengthText(result.noise_floor, units));
    case Verdict::kPartlyExplained:
      return fmt::format("Missing: {}. With it the held-out error falls from {} to {}; {}.", names.front(),
                         lengthText(result.heldout_before.rms, units), lengthText(result.heldout_after.rms, units),
                         remainderText(result, units));
    case Verdict::kAmbiguous:
      return fmt::format("One of {} explanations is missing, which these readings cannot tell apart; first {}.",
                         result.alternatives.size(), namesText(result.alternatives.front()));
    case Verdict::kUnexplained:
      return unexplainedSentence(result, units);
    case Verdict::kInconclusive:
      return inconclusiveSentence(result);
  }
  return "";
}

namespace {

nlohmann::json remainderJson(const calibration::Remainder& remainder, const Units& units) {
  nlohmann::json follows = nlohmann::json::array();
  for (const auto& [name, share] : remainder.follows) follows.push_back({{"variable", name}, {"share", share}});
  return {{"probability", finiteJson(remainder.probability)},
          {"size", lengthJson(remainder.size, units)},
          {"floor", lengthJson(remainder.floor, units)},
          {"follows", follows}};
}

}  // namespace

nlohmann::json diagnosisJson(const Diagnosis& result, const std::vector<Measurement>& readings, const Units& units) {
  nlohmann::json json = {
      {"verdict", nameOf(result.verdict)}, {"sentence", diagnosisSentence(result, units)}, {"units", unitsJson(units)}};
  json["alternatives"] = nlohmann::json::array();
  for (const auto& alternative : result.alternatives) {
    nlohmann::json effects = nlohmann::json::array();
    for (const auto& effect : alternative.effects) effects.push_back(effectJson(effect, units));
    json["alternatives"].push_back(effects);
  }
  json["closest"] = nlohmann::json::array();
  for (const auto& explanation : result.closest) {
    nlohmann::json effects = nlohmann::json::array();
    for (const auto& effect : explanation.effects) effects.push_back(effectJson(effect, units));
    json["closest"].push_back({{"effects", effects},
                               {"chi2", finiteJson(explanation.chi2)},
                               {"probability", finiteJson(explanation.probability)},
                               {"remainder_probability", finiteJson(explanation.remainder_probability)},
                               {"p_value", finiteJson(explanation.p_value)},
                               {"rms", lengthJson(explanation.after.rms, units)},
                               {"heldout_rms", lengthJson(explanation.heldout.rms, units)}});
  }
  json["ranking"] = nlohmann::json::array();
  for (const auto& entry : result.ranking) json["ranking"].push_back(rankedJson(entry, units));
  json["rms"] = {{"noise_floor", lengthJson(result.noise_floor, units)},
                 {"before", lengthJson(result.before.rms, units)},
                 {"after", lengthJson(result.after.rms, units)},
                 {"heldout_before", lengthJson(result.heldout_before.rms, units)},
                 {"heldout_after", lengthJson(result.heldout_after.rms, units)}};
  json["chi2_per_dof"] = finiteJson(result.chi2 / std::max(1, result.degrees_of_freedom));
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["p_value"] = finiteJson(result.p_value);
  json["probability"] = {{"nothing_missing", finiteJson(result.nothing_probability)},
                         {"unknown_alone", finiteJson(result.unknown_probability)}};
  json["model_error"] = lengthJson(result.model_error, units);
  if (std::isfinite(result.remainder.floor)) json["remainder"] = remainderJson(result.remainder, units);
  json["detectable"] = nlohmann::json::array();
  for (const auto& entry : result.detectable)
    json["detectable"].push_back({{"effect", entry.effect},
                                  {"at", entry.at},
                                  {"number", entry.number},
                                  {"size", finiteJson(entry.size / units.factor(dimensionOf(entry.quantity)))},
                                  {"unit", units.nameOf(dimensionOf(entry.quantity))},
                                  {"beyond_plausible", entry.is_beyond_plausible}});
  json["not_tried"] = result.not_tried;
  json["set_aside"] = nlohmann::json::array();
  for (const int reading : result.set_aside)
    json["set_aside"].push_back(readings.at(static_cast<std::size_t>(reading)).id);
  json["next_readings"] = nlohmann::json::array();
  json["explanations"] = explanationsJson(result, units);
  addViews(result, readings, units, json);
  return json;
}

namespace {

/// One alternative with its other names.
std::string alternativeText(const Explanation& alternative, const Units& units) {
  std::string text = fmt::format("  {:.3f}  {}\n", alternative.probability, explanationText(alternative, units));
  for (const auto& effect : alternative.effects) {
    std::vector<std::string> also;
    for (const auto& [name, at] : effect.also) also.push_back(name + "@" + at);
    if (!also.empty())
      text += fmt::format("         {}@{} is the same all over the arm's range as {}\n", effect.effect, effect.at,
                          fmt::join(also, ", "));
    for (const auto& number : effect.numbers)
      if (number.is_beyond_usual)
        text += fmt::format("         {} of {}@{} is larger than real machines have\n", number.name, effect.effect, effect.at);
  }
  return text;
}

}  // namespace

std::string diagnosisText(const Diagnosis& result, const std::vector<Measurement>& readings, const Units& units) {
  std::string text = fmt::format("{}\n{}\n", nameOf(result.verdict), diagnosisSentence(result, units));
  if (result.verdict == Verdict::kNotRun) return text;
  text +=
      fmt::format("chi-square {:.1f} for {} degrees of freedom{}\n", result.chi2, result.degrees_of_freedom,
                  std::isfinite(result.nothing_probability)
                      ? fmt::format("; nothing missing has probability {:.3g}", result.nothing_probability)
                      : "");
  if (result.model_error > 0)
    text += fmt::format("about {} in each coordinate beyond the stated noise is no function of the readings\n",
                        lengthText(result.model_error, units));
  for (const auto& alternative : result.alternatives) text += alternativeText(alternative, units);
  text += "  effect                                  probability   chi-square falls by   size\n";
  for (std::size_t k = 0; k < result.ranking.size() && k < 10; ++k) {
    const auto& entry = result.ranking[k];
    text += fmt::format("  {:<40} {:>9.3f} {:>15.1f}   {}\n", entry.effect + "@" + entry.at, entry.probability,
                        entry.fall, numberText(entry.size, units));
  }
  for (std::size_t k = 0; k < result.closest.size() && k < 6; ++k)
    text += fmt::format("  fitted: {}: probability {:.3f}, chi-square {:.1f}, rms {}\n",
                        explanationText(result.closest[k], units), result.closest[k].probability,
                        result.closest[k].chi2, lengthText(result.closest[k].after.rms, units));
  for (const int reading : result.set_aside)
    text += fmt::format("  set aside as an outlier: reading {}\n", readings.at(static_cast<std::size_t>(reading)).id);
  for (const auto& lack : result.not_tried) text += "  not tried: " + lack + "\n";
  return text;
}

}  // namespace tubeplan::app
