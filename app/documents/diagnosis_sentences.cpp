#include "app/documents/diagnosis_sentences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/estimation/size_modes.hpp"

namespace tubeplan::app {

namespace {

using calibration::causeTitle, calibration::Diagnosis, calibration::Explanation, calibration::FoundEffect,
    calibration::FoundNumber, calibration::Measurement, calibration::Verdict;

constexpr int kDigits = 3;  // significant digits of a length in a sentence

/// Returns a string such as "0.0586 ± 0.0010": sigma with two significant digits, and the value with the same number of
/// decimals.
std::string withSigmaText(double value, double sigma) {
  constexpr double kLeastPlain = 1e-3, kMostPlain = 1e5;
  const double size = std::max(std::abs(value), sigma);
  if (!(sigma > 0) || size < kLeastPlain || size >= kMostPlain) return fmt::format("{:.3g} ± {:.2g}", value, sigma);
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, 9);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, sigma, decimals);
}

bool isFreed(const FoundEffect& effect) { return effect.effect == calibration::kFreedNumbers; }

/// Joins the titles of effects, and behind them those of freed parameters, which are clauses of their own.
std::string joinedTitles(const std::vector<std::string>& effects, const std::vector<std::string>& freed) {
  const std::string of_effects = fmt::format("{}", fmt::join(effects, " and "));
  return of_effects + (effects.empty() || freed.empty() ? "" : "; ") + fmt::format("{}", fmt::join(freed, "; "));
}

/// Returns a string such as "joint-compliance at theta2-row.z (softness 0.0021 ± 0.0001 rad/kNm)"; for more than three
/// parameters, only the number of parameters is given.
std::string foundText(const FoundEffect& effect, const Units& units) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> numbers;
  for (const auto& number : effect.numbers)
    if (std::isfinite(number.sigma) || number.quantity == deflection::Quantity::kTime)
      numbers.push_back(numberText(number, units));
  const std::string name = causeTitle(effect.effect, effect.at);
  if (numbers.size() > kMost) return fmt::format("{} ({} numbers)", name, numbers.size());
  return numbers.empty() ? name : fmt::format("{} ({})", name, fmt::join(numbers, ", "));
}

/// Returns a string that lists the effects of an explanation, with their parameter values if the result is short enough
/// for a sentence.
std::string shortText(const Explanation& explanation, const Units& units) {
  constexpr std::size_t kShort = 90;
  const std::string text = sizesText(explanation, units);
  return text.size() <= kShort ? text : namesText(explanation);
}

/// Returns a string such as "gravity-sag at 6 places, certain at joint_2, joint_3"; the sizes at the other places are
/// within two standard deviations of nothing.
std::string placesText(const std::string& name, const std::vector<const FoundEffect*>& alike) {
  std::vector<std::string> seen;
  for (const FoundEffect* effect : alike)
    if (effect->fitted.kind >= 0 && calibration::significanceOf(*effect) > calibration::kFoundSigmas)
      seen.push_back(effect->at);
  const std::string all = fmt::format("{} at {} places", name, alike.size());
  return seen.empty() || seen.size() == alike.size() ? all
                                                     : fmt::format("{}, certain at {}", all, fmt::join(seen, ", "));
}

bool contains(const Explanation& explanation, const std::string& effect, const std::string& at) {
  return std::ranges::any_of(explanation.effects,
                             [&](const FoundEffect& found) { return found.effect == effect && found.at == at; });
}

/// Returns a clause such as ", or joint-offset at A5, which ..."; of several effects, it names the one that the other
/// may replace. Empty if no other effect has the same consequences.
std::string orText(const Explanation& explanation) {
  std::vector<std::string> clauses;
  for (const auto& effect : explanation.effects) {
    std::vector<std::string> others;
    for (const auto& [name, at] : effect.indistinguishable)
      if (!contains(explanation, name, at)) others.push_back(causeTitle(name, at));
    if (others.empty()) continue;
    const std::string instead = fmt::format("{}", fmt::join(others, " or "));
    clauses.push_back(explanation.effects.size() == 1
                          ? instead
                          : fmt::format("{} in place of {}", instead, causeTitle(effect.effect, effect.at)));
  }
  if (clauses.empty()) return "";
  return fmt::format(", or {}, which no reading with this tool can distinguish", fmt::join(clauses, ", or "));
}

/// Returns the variables on which the unexplained residual depends, with the fraction that each one explains, such as
/// "load (50 %), theta1 (20 %)".
std::string followsText(const calibration::Remainder& remainder) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> variables;
  for (std::size_t k = 0; k < std::min(kMost, remainder.follows.size()); ++k)
    variables.push_back(fmt::format("{} ({:.0f} %)", remainder.follows[k].first, 100 * remainder.follows[k].second));
  return fmt::format("{}", fmt::join(variables, ", "));
}

/// Returns an error of the diagnosed measurements as text, with its unit.
std::string errorText(double error, const Diagnosis& result, const Units& units, int digits = kDigits) {
  return errorText(error, errorUnitOf(result.before.are_angles, units), digits);
}

std::string remainderSentence(const Diagnosis& result, const Units& units) {
  const auto& remainder = result.remainder;
  if (!std::isfinite(remainder.size)) return "";
  const std::string size = errorText(budgetOf(result).remainder, result, units);
  if (remainder.follows.empty()) return fmt::format("{} remains that {}.", size, kFollowsNothing);
  const char* unexplained =
      result.verdict == Verdict::kUnexplained ? "no known effect is certain to explain" : "no known effect explains";
  return fmt::format("{} remains that {}; it follows {}.", size, unexplained, followsText(remainder));
}

/// Returns a sentence that compares the scatter of repeated measurements with the stated noise; empty if no
/// measurements are repeated.
std::string repeatsSentence(const calibration::Repeats& repeats) {
  if (repeats.groups == 0) return "";
  return fmt::format("Repeated readings scatter {:.2f} times as much as stated, and this explains the whole remainder.",
                     repeats.noise_ratio);
}

std::string nothingSentence(const Diagnosis& result, const Units& units) {
  return fmt::format("Nothing is missing: the error of {} is explained by noise ({}).",
                     errorText(budgetOf(result).total, result, units), errorText(result.noise_floor, result, units));
}

std::string missingSentence(const Diagnosis& result, const Units& units) {
  const Explanation& found = result.alternatives.front();
  const bool is_freed = std::ranges::all_of(found.effects, isFreed);
  return fmt::format("{}{}{}.", is_freed ? "" : "Missing: ", shortText(found, units), orText(found));
}

/// Returns a sentence such as "base-slip at base has 3 sizes that explain the measurements equally; ..."; empty if all
/// effects have unique values.
std::string modesSentence(const Explanation& explanation) {
  std::vector<std::string> sentences;
  for (const auto& effect : explanation.effects) {
    if (effect.modes.empty()) continue;
    sentences.push_back(fmt::format("{} has {} sizes that explain the readings equally; {}.",
                                    causeTitle(effect.effect, effect.at), effect.modes.size(),
                                    calibration::decidedByText(effect.decided_by)));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

/// Returns a sentence on the decrease of the error. An error far below the noise floor is only stated as "less than the
/// noise floor"; it occurs for measurements that only bound an error.
std::string fallSentence(const Diagnosis& result, const Units& units) {
  constexpr double kNothing = 0.5;  // fraction of the noise floor below which the value of an error is not given
  if (result.heldout_after.rms < kNothing * result.noise_floor)
    return fmt::format("With it the held-out error falls from {} to less than the noise floor of {}.",
                       errorText(result.heldout_before.rms, result, units),
                       errorText(result.noise_floor, result, units));
  return fmt::format("With it the held-out error falls from {} to {}; the noise floor is {}.",
                     errorText(result.heldout_before.rms, result, units),
                     errorText(result.heldout_after.rms, result, units), errorText(result.noise_floor, result, units));
}

std::string scatterSentence(const Diagnosis& result, const Units& units) {
  return fmt::format(
      "The readings scatter by {} beyond their stated noise, and this scatter {}: sigma is too small, the arm is not "
      "repeatable, an unrecorded influence acts on it, or the error changes too fast for these readings (with time, or "
      "with a joint, as from a gear or a screw).",
      errorText(budgetOf(result).remainder, result, units), kFollowsNothing);
}

/// Returns the sentence for an error that is within the stated noise but not random.
std::string withinNoiseSentence(const Diagnosis& result, const Units& units) {
  const std::string follows =
      result.remainder.follows.empty() ? "" : " (it follows " + followsText(result.remainder) + ")";
  return fmt::format(
      "The error of {} is within the stated noise of {}, but it is not random{}: the stated sigma is too large, or a "
      "small effect is missing that these readings cannot identify.",
      errorText(budgetOf(result).total, result, units), errorText(result.noise_floor, result, units), follows);
}

constexpr double kWorthNaming = 0.03;  // smallest probability of an unknown cause that a sentence mentions

std::string ambiguousSentence(const Diagnosis& result) {
  if (result.alternatives.size() == 1)
    return fmt::format("The most probable cause is {}, but it may be something unknown (probability {:.0f} %).",
                       namesText(result.alternatives.front()), 100 * result.unknown_probability);
  const std::string unknown =
      result.unknown_probability < kWorthNaming
          ? ""
          : fmt::format(", or something unknown (probability {:.0f} %)", 100 * result.unknown_probability);
  return fmt::format(
      "{} explanations are possible, which these readings cannot distinguish{}; the most probable is {}.",
      result.alternatives.size(), unknown, namesText(result.alternatives.front()));
}

std::string inconclusiveSentence(const Diagnosis& result) {
  if (!result.reason.empty()) return noVerdictSentence(result.reason);
  return fmt::format(
      "The readings suggest that something is missing (probability {:.0f} %), but do not show what it is.",
      100 * (1 - result.nothing_probability));
}

/// Returns a sentence on the uncertain explanation that lowers the held-out error most; empty if none halves it.
std::string closestSentence(const Diagnosis& result, const Units& units) {
  constexpr double kMuch = 0.5;
  const Explanation* closest = nullptr;
  for (const Explanation& explanation : result.closest)
    if (explanation.heldout.rms < (closest ? closest->heldout.rms : kMuch * result.heldout_before.rms))
      closest = &explanation;
  if (!closest) return "";
  return fmt::format("Not certain, but closest: with {} the held-out error would fall from {} to {}.",
                     namesText(*closest), errorText(result.heldout_before.rms, result, units),
                     errorText(closest->heldout.rms, result, units));
}

/// Returns the sentences of a diagnosis; those that do not apply are empty.
std::vector<std::string> sentencesOf(const Diagnosis& result, const Units& units) {
  switch (result.verdict) {
    case Verdict::kNotRun:
    case Verdict::kStopped:
      return {"Not diagnosed: " + result.reason + "."};
    case Verdict::kAdequate:
      return {nothingSentence(result, units), repeatsSentence(result.repeats)};
    case Verdict::kExplained:
      return {missingSentence(result, units), modesSentence(result.alternatives.front()), fallSentence(result, units),
              repeatsSentence(result.repeats)};
    case Verdict::kPartlyExplained:
      return {missingSentence(result, units), modesSentence(result.alternatives.front()), fallSentence(result, units),
              remainderSentence(result, units)};
    case Verdict::kAmbiguous:
      return {ambiguousSentence(result), modesSentence(result.alternatives.front()), fallSentence(result, units)};
    case Verdict::kUnexplained:
      if (budgetOf(result).remainder == 0) return {withinNoiseSentence(result, units)};
      if (result.isScatterAlone()) return {scatterSentence(result, units)};
      return {"Something is missing, and no known effect is certain to be part of it.", closestSentence(result, units),
              remainderSentence(result, units)};
    case Verdict::kInconclusive:
      return {inconclusiveSentence(result)};
  }
  return {};
}

}  // namespace

std::string numberText(const FoundNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  const std::string unit_name = units.nameOf(unit) == "1" ? "" : " " + units.nameOf(unit);
  const double factor = units.factor(unit), value = number.value / factor, sigma = number.sigma / factor;
  std::string name = number.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (std::isfinite(number.lower))
    return fmt::format("{} {:.3g} to {:.3g}{}", name, number.lower / factor, number.upper / factor, unit_name);
  return fmt::format("{} {}{}", name, std::isnan(sigma) ? fmt::format("{:.3g}", value) : withSigmaText(value, sigma),
                     unit_name);
}

std::string sizesText(const Explanation& explanation, const Units& units) {
  std::vector<std::string> effects, freed;
  for (const auto& effect : explanation.effects)
    (isFreed(effect) ? freed : effects).push_back(foundText(effect, units));
  return joinedTitles(effects, freed);
}

std::vector<std::string> idsOf(const std::vector<int>& places, const std::vector<Measurement>& measurements) {
  std::vector<std::string> ids;
  for (const int place : places) ids.push_back(measurements.at(static_cast<std::size_t>(place)).id);
  return ids;
}

std::string namesText(const Explanation& explanation) {
  constexpr std::size_t kMany = 3;
  std::vector<std::string> names, freed;
  for (const auto& effect : explanation.effects) {
    std::vector<const FoundEffect*> alike;
    for (const auto& other : explanation.effects)
      if (other.effect == effect.effect) alike.push_back(&other);
    std::vector<std::string>& target = isFreed(effect) ? freed : names;
    const std::string name = alike.size() < kMany || isFreed(effect) ? causeTitle(effect.effect, effect.at)
                                                                     : placesText(effect.effect, alike);
    if (std::find(target.begin(), target.end(), name) == target.end()) target.push_back(name);
  }
  return joinedTitles(names, freed);
}

std::string indistinguishableText(const FoundEffect& effect) {
  std::vector<std::string> others;
  for (const auto& [name, at] : effect.indistinguishable) others.push_back(causeTitle(name, at));
  if (others.empty()) return "";
  return fmt::format("no reading with this tool can distinguish {} from {}", causeTitle(effect.effect, effect.at),
                     fmt::join(others, ", "));
}

std::vector<std::string> diagnosisSentences(const Diagnosis& result, const Units& units) {
  std::vector<std::string> sentences = sentencesOf(result, units);
  std::erase(sentences, "");
  return sentences;
}

std::string diagnosisSentence(const Diagnosis& result, const Units& units) {
  return fmt::format("{}", fmt::join(diagnosisSentences(result, units), " "));
}

std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm, const Units& units) {
  return found.frees.empty() ? effectText(arm, found.fitted, units) : found.effect + "@" + found.at;
}

}  // namespace tubeplan::app
