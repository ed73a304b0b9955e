#include "app/documents/diagnosis_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/documents/diagnosis_sentences.hpp"
#include "app/documents/diagnosis_views_json.hpp"
#include "app/documents/discrimination_json.hpp"
#include "app/documents/effect_words_json.hpp"
#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/units_json.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::FoundEffect, calibration::FoundNumber,
    calibration::Measurement, calibration::RankedEffect;

nlohmann::json numberJson(const FoundNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  nlohmann::json json = {{"name", number.name},
                         {"value", finiteJson(number.value / units.factor(unit))},
                         {"sigma", finiteJson(number.sigma / units.factor(unit))},
                         {"unit", units.nameOf(unit)},
                         {"words", numberText(number, units)}};
  if (std::isfinite(number.lower))
    json["interval"] = {number.lower / units.factor(unit), number.upper / units.factor(unit)};
  return json;
}

/// Adds the sets of parameter values that explain the measurements equally well, and the kinds of measurement that
/// would decide between them.
void addModes(const FoundEffect& effect, const Units& units, nlohmann::json& json) {
  if (effect.modes.empty()) return;
  for (const auto& values : effect.modes) {
    nlohmann::json mode;
    for (std::size_t k = 0; k < effect.numbers.size(); ++k)
      mode[effect.numbers[k].name] = finiteJson(values[k] / units.factor(dimensionOf(effect.numbers[k].quantity)));
    json["modes"].push_back(mode);
  }
  json["decided_by"] = nlohmann::json::array();
  for (const auto kind : effect.decided_by) json["decided_by"].push_back(calibration::kindOf(kind).name);
}

nlohmann::json effectJson(const FoundEffect& effect, const deflection::Arm& arm, const Units& units) {
  nlohmann::json parameters = nlohmann::json::object();
  for (const auto& number : effect.numbers) {
    parameters[number.name] = numberJson(number, units);
    if (number.is_beyond_usual) parameters[number.name]["beyond_usual"] = true;
    parameters[number.name].erase("name");
  }
  nlohmann::json indistinguishable = nlohmann::json::array();
  for (const auto& [name, at] : effect.indistinguishable) indistinguishable.push_back({{"effect", name}, {"at", at}});
  nlohmann::json json = {{"effect", effect.effect},
                         {"at", effect.at},
                         {"parameters", parameters},
                         {"also", indistinguishable},
                         {"add", additionText(effect, arm, units)}};
  for (const auto& number : effect.numbers)
    if (number.is_beyond_usual) json["beyond_usual"].push_back(number.name);
  if (!effect.indistinguishable.empty()) json["also_words"] = indistinguishableText(effect);
  if (!effect.frees.empty()) json["frees"] = effect.frees;
  addModes(effect, units, json);
  addEffectWords(effect.effect, json);
  return json;
}

nlohmann::json rankedJson(const RankedEffect& entry, const deflection::Arm& arm, const ErrorUnit& unit,
                          const Units& units) {
  const bool is_one = entry.effects.size() == 1;
  nlohmann::json json = {
      {"effect", entry.effect},
      {"add", is_one ? effectText(arm, entry.effects.front(), units) : entry.effect + "@" + entry.at},
      {"at", entry.at},
      {"probability", finiteJson(entry.probability)},
      {"p_value", finiteJson(entry.p_value)},
      {"chi2_fall", finiteJson(entry.fall)},
      {"size", numberJson(entry.size, units)},
      {"kept_fraction", finiteJson(entry.kept_fraction)},
      {"heldout_rms",
       {{"before", errorJson(entry.heldout_before.rms, unit)}, {"after", errorJson(entry.heldout_after.rms, unit)}}}};
  addEffectWords(entry.effect, json);
  return json;
}

nlohmann::json effectsJson(const Explanation& explanation, const Diagnosis& result, const Units& units) {
  nlohmann::json effects = nlohmann::json::array();
  for (const auto& effect : explanation.effects)
    effects.push_back(effectJson(effect, result.baseline.fitted.arm, units));
  return effects;
}

/// Returns the JSON of an explanation with its probability and the errors that remain.
nlohmann::json explanationJson(const Explanation& explanation, const Diagnosis& result, const Units& units) {
  const ErrorUnit unit = errorUnitOf(result.before.are_angles, units);
  return {{"effects", effectsJson(explanation, result, units)},
          {"found", sizesText(explanation, units)},
          {"chi2", finiteJson(explanation.chi2)},
          {"probability", finiteJson(explanation.probability)},
          {"remainder_probability", finiteJson(explanation.remainder_probability)},
          {"p_value", finiteJson(explanation.p_value)},
          {"rms", errorJson(explanation.after.rms, unit)},
          {"heldout_rms", errorJson(explanation.heldout.rms, unit)}};
}

/// Returns the JSON of the explanations that are shown to the user.
nlohmann::json explanationsJson(const Diagnosis& result, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& explanation : calibration::explanationsShown(result)) {
    list.push_back(explanationJson(explanation, result, units));
    list.back()["enough"] = !result.alternatives.empty();
  }
  return list;
}

nlohmann::json remainderJson(const Diagnosis& result, const ErrorUnit& unit) {
  const auto& remainder = result.remainder;
  nlohmann::json follows = nlohmann::json::array();
  for (const auto& [name, share] : remainder.follows) follows.push_back({{"variable", name}, {"share", share}});
  return {{"probability", finiteJson(remainder.probability)},
          {"size", errorJson(budgetOf(result).remainder, unit)},
          {"floor", errorJson(remainder.floor, unit)},
          {"follows", follows}};
}

/// Returns the smallest detectable magnitude of each effect at each place; `best` marks the smallest one of each
/// effect.
nlohmann::json detectableJson(const std::vector<calibration::DetectableEffect>& detectable, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& entry : detectable) {
    const auto best = std::ranges::min_element(detectable, {}, [&](const auto& other) {
      return std::tuple(other.effect != entry.effect, !std::isfinite(other.size), other.is_beyond_plausible,
                        other.size);
    });
    list.push_back({{"effect", entry.effect},
                    {"at", entry.at},
                    {"number", entry.number},
                    {"size", finiteJson(entry.size / units.factor(dimensionOf(entry.quantity)))},
                    {"unit", units.nameOf(dimensionOf(entry.quantity))},
                    {"beyond_plausible", entry.is_beyond_plausible},
                    {"best", &*best == &entry}});
  }
  return list;
}

constexpr TextLine kFoundEffectWords[] = {
    {"also_words", "         {}\n"},
    {"beyond_usual", "         {} of {effect} at {at} is larger than in real machines\n"}};
constexpr TextLine kFoundWords[] = {{"", "  {probability:.3f}  {found}\n"}, {"effects", "", kFoundEffectWords}};

constexpr TextLine kLeastWords[] = {{"size", "{size:>9.3r} {unit}"},
                                    {"!size", "not detectable: it moves none of these readings"},
                                    {"beyond_plausible", " (more than in real machines)"},
                                    {"", "\n"}};
constexpr TextLine kDetectableWords[] = {
    {"detectable", "  smallest size that would be detected with a power of 80 %:\n", {}, {}, 1},
    {"detectable/best", "    {effect:<24} {at:<22} ", kLeastWords}};

constexpr TextLine kDiagnosisWords[] = {
    {"", "{verdict}\n"},
    {"sentences", "{}\n"},
    {"degrees_of_freedom", "chi-square {chi2_per_dof:.3r} for each of {} degrees of freedom ({p_value:p})\n"},
    {"probability/nothing_missing", "nothing missing has probability {:.3r}\n"},
    {"+model_error",
     "scatter of about {:.3r error_unit} in each coordinate (one standard deviation) beyond the stated noise is not a "
     "smooth function of anything that the readings record\n"},
    {"error_budget", "{words}\n"},
    {"explanations/enough", "", kFoundWords},
    {"ranking",
     "  effect                   at                     is there   chi2 falls by   size   ({probability_words})\n",
     {},
     {},
     1},
    {"ranking", "  {effect:<24} {at:<22} {probability:>8.3f} {chi2_fall:>15.1f}   {size/words}\n", {}, {}, 10},
    {"closest",
     "  fitted: {found}: probability {probability:.3f}, chi-square {chi2:.1f}, rms {rms:.4r error_unit}\n",
     {},
     {},
     6},
    {"set_aside", kSetAsideWords, {}, {}, 1},
    {"not_tried", "  not tried: {}\n"},
    {"!alternatives", "", kDetectableWords}};

constexpr TextLine kAdditionWords[] = {
    {"", "to add it: tubeplan add {cell}"}, {"effects", " '{add}'"}, {"", " --out better.yaml\n"}};
constexpr TextLine kNextStepWords[] = {{"explanations/enough", "", kAdditionWords, {}, 1}};

}  // namespace

std::string diagnosisText(const nlohmann::json& figures) {
  return textOf(figures, kDiagnosisWords) + discriminationText(figures);
}

std::string additionCommand(nlohmann::json figures, const std::string& cell) {
  figures["cell"] = cell;
  return textOf(figures, kNextStepWords);
}

nlohmann::json diagnosisJson(const Diagnosis& result, const std::vector<Measurement>& measurements,
                             const Units& units) {
  const ErrorUnit unit = errorUnitOf(result.before.are_angles, units);
  nlohmann::json json = {{"verdict", nameOf(result.verdict)},
                         {"verdict_words", wordsOf(result.verdict)},
                         {"sentence", diagnosisSentence(result, units)},
                         {"sentences", diagnosisSentences(result, units)},
                         {"units", measurementUnitsJson(units)}};
  json["alternatives"] = nlohmann::json::array();
  for (const auto& alternative : result.alternatives)
    json["alternatives"].push_back(effectsJson(alternative, result, units));
  json["closest"] = nlohmann::json::array();
  for (const auto& explanation : result.closest) json["closest"].push_back(explanationJson(explanation, result, units));
  json["ranking"] = nlohmann::json::array();
  for (const auto& entry : result.ranking)
    json["ranking"].push_back(rankedJson(entry, result.baseline.fitted.arm, unit, units));
  json["rms"] = {{"noise_floor", errorJson(result.noise_floor, unit)},
                 {"before", errorJson(result.before.rms, unit)},
                 {"after", errorJson(result.after.rms, unit)},
                 {"heldout_before", errorJson(result.heldout_before.rms, unit)},
                 {"heldout_after", errorJson(result.heldout_after.rms, unit)}};
  json["error_unit"] = unit.name;
  json["error_budget"] = errorBudgetJson(budgetOf(result), result.set_aside.size(), units);
  json["probability_words"] = kProbabilityWords;
  json["chi2_per_dof"] = finiteJson(result.chi2 / std::max(1, result.degrees_of_freedom));
  json["degrees_of_freedom"] = result.degrees_of_freedom;
  json["p_value"] = finiteJson(result.p_value);
  json["probability"] = {{"nothing_missing", finiteJson(result.nothing_probability)},
                         {"unknown_alone", finiteJson(result.unknown_probability)},
                         {"scatter_alone", finiteJson(result.scatter_probability)}};
  json["model_error"] = errorJson(result.model_error, unit);
  if (result.repeats.groups > 0)
    json["repeats"] = {{"groups", result.repeats.groups}, {"noise_ratio", finiteJson(result.repeats.noise_ratio)}};
  if (std::isfinite(result.remainder.floor)) json["remainder"] = remainderJson(result, unit);
  json["detectable"] = detectableJson(result.detectable, units);
  json["not_tried"] = result.not_tried;
  json["set_aside"] = idsOf(result.set_aside, measurements);
  json["next_readings"] = nlohmann::json::array();
  json["explanations"] = explanationsJson(result, units);
  addViews(result, measurements, units, json);
  return json;
}

}  // namespace tubeplan::app
