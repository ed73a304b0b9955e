#include "app/documents/diagnosis_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/documents/figures.hpp"
#include "app/files/effects_reader.hpp"
#include "app/files/input_error.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::FoundEffect, calibration::FoundNumber,
    calibration::Measurement, calibration::Verdict;

std::string numberText(const FoundNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  const std::string name = units.nameOf(unit) == "1" ? "" : " " + units.nameOf(unit);
  if (std::isnan(number.sigma)) return fmt::format("{} {:.3g}{}", number.name, number.value / units.factor(unit), name);
  return fmt::format("{} {:.3g} ± {:.2g}{}", number.name, number.value / units.factor(unit),
                     number.sigma / units.factor(unit), name);
}

/// "joint-compliance@theta2-row.z (softness 0.0021 ± 0.0001 rad/kNm)"; of many numbers only how many.
std::string foundText(const FoundEffect& effect, const Units& units) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> numbers;
  for (const auto& number : effect.numbers)
    if (std::isfinite(number.sigma) || number.quantity == deflection::Quantity::kTime)
      numbers.push_back(numberText(number, units));
  const std::string name = effect.effect + "@" + effect.at;
  if (numbers.size() > kMost) return fmt::format("{} ({} numbers)", name, numbers.size());
  return numbers.empty() ? name : fmt::format("{} ({})", name, fmt::join(numbers, ", "));
}

std::string explanationText(const Explanation& explanation, const Units& units) {
  std::vector<std::string> effects;
  for (const auto& effect : explanation.effects) effects.push_back(foundText(effect, units));
  return fmt::format("{}", fmt::join(effects, " with "));
}

/// By names; one effect at many places once.
std::string namesText(const Explanation& explanation) {
  constexpr long kMany = 3;
  std::vector<std::string> names;
  for (const auto& effect : explanation.effects) {
    const long places = std::count_if(explanation.effects.begin(), explanation.effects.end(),
                                      [&](const FoundEffect& other) { return other.effect == effect.effect; });
    const std::string name =
        places < kMany ? effect.effect + "@" + effect.at : fmt::format("{} at {} places", effect.effect, places);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, " with "));
}

/// With sizes where that is short.
std::string shortText(const Explanation& explanation, const Units& units) {
  constexpr std::size_t kShort = 90;
  const std::string text = explanationText(explanation, units);
  return text.size() <= kShort ? text : namesText(explanation);
}

/// ", or joint-offset@A5 in place of link-length@bend, which ..."; empty where no cause has other names.
std::string orText(const Explanation& explanation) {
  std::vector<std::string> others;
  for (const auto& effect : explanation.effects)
    for (const auto& [name, at] : effect.also)
      others.push_back(fmt::format("{}@{} in place of {}@{}", name, at, effect.effect, effect.at));
  if (others.empty()) return "";
  return fmt::format(", or {}, which no reading with this tool tells apart", fmt::join(others, " and "));
}

std::string followsText(const calibration::Remainder& remainder) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < remainder.follows.size() && k < 2; ++k) names.push_back(remainder.follows[k].first);
  return names.empty() ? "" : fmt::format(", mostly with {}", fmt::join(names, " and "));
}

std::string remainderText(const Diagnosis& result, const Units& units) {
  const auto& remainder = result.remainder;
  if (!std::isfinite(remainder.size)) return "";
  if (remainder.follows.empty())
    return fmt::format("{} remains that {}", lengthText(remainder.size, units), kFollowsNothing);
  return fmt::format("{} remains that no known effect explains{}", lengthText(remainder.size, units),
                     followsText(remainder));
}

/// Where readings that were repeated say that the noise is larger than stated.
std::string repeatsText(const calibration::Repeats& repeats) {
  if (repeats.groups == 0) return "";
  return fmt::format(" Repeated readings scatter {:.2f} times as much as stated, and this is all that is left.",
                     repeats.noise_ratio);
}

std::string unexplainedSentence(const Diagnosis& result, const Units& units) {
  if (result.isScatterAlone())
    return fmt::format(
        "The readings scatter by {} beyond their stated noise, and this scatter {}: sigma is too small, the arm does "
        "not repeat, something unrecorded acts on it, or it changes too fast for these readings: with time, or with a "
        "joint as the turns of a gear or a screw do.",
        lengthText(result.remainder.size, units), kFollowsNothing);
  const std::string rest = remainderText(result, units);
  return fmt::format("Something is missing, and no known effect is certain to be part of it{}.",
                     rest.empty() ? "" : ": " + rest);
}

constexpr double kWorthNaming = 0.03;  // probability of something unknown beside the explanations

std::string ambiguousSentence(const Diagnosis& result) {
  if (result.alternatives.size() == 1)
    return fmt::format("Most likely {} is missing, but it may be something unknown (probability {:.0f} %).",
                       namesText(result.alternatives.front()), 100 * result.unknown_probability);
  const std::string unknown =
      result.unknown_probability < kWorthNaming
          ? ""
          : fmt::format(", or something unknown (probability {:.0f} %)", 100 * result.unknown_probability);
  return fmt::format(
      "One of {} explanations is missing, which these readings cannot distinguish{}; the most probable is {}.",
      result.alternatives.size(), unknown, namesText(result.alternatives.front()));
}

std::string inconclusiveSentence(const Diagnosis& result) {
  if (!result.reason.empty())
    return "No verdict is possible: " + result.reason + (result.reason.ends_with('?') ? "" : ".");
  return fmt::format(
      "The readings suggest that something is missing (probability {:.0f} %), but not enough to say what.",
      100 * (1 - result.nothing_probability));
}

}  // namespace

std::vector<std::string> idsOf(const std::vector<int>& places, const std::vector<Measurement>& readings) {
  std::vector<std::string> ids;
  for (const int place : places) ids.push_back(readings.at(static_cast<std::size_t>(place)).id);
  return ids;
}

std::string diagnosisSentence(const Diagnosis& result, const Units& units) {
  const std::string first = result.alternatives.empty()
                                ? ""
                                : shortText(result.alternatives.front(), units) + orText(result.alternatives.front());
  switch (result.verdict) {
    case Verdict::kNotRun:
    case Verdict::kStopped:
      return "Not diagnosed: " + result.reason + ".";
    case Verdict::kAdequate:
      return fmt::format("Nothing is missing: the error of {} is explained by noise ({}).{}",
                         lengthText(result.before.rms, units), lengthText(result.noise_floor, units),
                         repeatsText(result.repeats));
    case Verdict::kExplained:
      return fmt::format("Missing: {}. With it the held-out error falls from {} to {}; the noise floor is {}.{}", first,
                         lengthText(result.heldout_before.rms, units), lengthText(result.heldout_after.rms, units),
                         lengthText(result.noise_floor, units), repeatsText(result.repeats));
    case Verdict::kPartlyExplained:
      return fmt::format("Missing: {}. With it the held-out error falls from {} to {}; {}.", first,
                         lengthText(result.heldout_before.rms, units), lengthText(result.heldout_after.rms, units),
                         remainderText(result, units));
    case Verdict::kAmbiguous:
      return ambiguousSentence(result);
    case Verdict::kUnexplained:
      return unexplainedSentence(result, units);
    case Verdict::kInconclusive:
      return inconclusiveSentence(result);
  }
  return "";
}

namespace {

/// One alternative with its other names.
std::string alternativeText(const Explanation& alternative, const Units& units) {
  std::string text = fmt::format("  {:.3f}  {}\n", alternative.probability, explanationText(alternative, units));
  for (const auto& effect : alternative.effects) {
    std::vector<std::string> also;
    for (const auto& [name, at] : effect.also) also.push_back(name + "@" + at);
    if (!also.empty())
      text += fmt::format("         with this tool no reading tells {}@{} apart from {}\n", effect.effect, effect.at,
                          fmt::join(also, ", "));
    for (const auto& number : effect.numbers)
      if (number.is_beyond_usual)
        text += fmt::format("         {} of {}@{} is larger than in real machines\n", number.name, effect.effect,
                            effect.at);
  }
  return text;
}

/// The least of each kind that would have been seen, at the place where it shows best.
std::string detectableText(const Diagnosis& result, const Units& units) {
  std::map<std::string, const calibration::DetectableEffect*> least;
  for (const auto& entry : result.detectable) {
    const auto*& kept = least[entry.effect];
    if (!kept ||
        std::make_pair(entry.is_beyond_plausible, entry.size) < std::make_pair(kept->is_beyond_plausible, kept->size))
      kept = &entry;
  }
  std::string text = least.empty() ? "" : "  smallest size that would be detected with a power of 80 %:\n";
  for (const auto& [effect, entry] : least) {
    const Dimension unit = dimensionOf(entry->quantity);
    if (!std::isfinite(entry->size)) {
      text += fmt::format("    {:<24} {:<22} not detectable: it moves none of these readings\n", effect, entry->at);
      continue;
    }
    text += fmt::format("    {:<24} {:<22} {:>9.3g} {}{}\n", effect, entry->at, entry->size / units.factor(unit),
                        units.nameOf(unit), entry->is_beyond_plausible ? " (more than in real machines)" : "");
  }
  return text;
}

}  // namespace

std::string additionCommand(const Diagnosis& result, const std::string& cell, const Units& units) {
  if (result.alternatives.empty()) return "";
  std::string causes;
  for (const auto& effect : result.alternatives.front().effects)
    causes += " '" + additionText(effect, result.baseline.fitted.arm, units) + "'";
  return fmt::format("to add it: tubeplan add {}{} --out better.yaml\n", cell, causes);
}

std::string diagnosisText(const Diagnosis& result, const std::vector<Measurement>& readings, const Units& units) {
  std::string text = fmt::format("{}\n{}\n", nameOf(result.verdict), diagnosisSentence(result, units));
  if (result.verdict == Verdict::kNotRun) return text;
  text += fmt::format("chi-square {:.1f} for {} degrees of freedom\n", result.chi2, result.degrees_of_freedom);
  if (std::isfinite(result.nothing_probability))
    text += fmt::format("nothing missing has probability {:.3g}\n", result.nothing_probability);
  if (result.model_error > 0)
    text += fmt::format("about {} in each coordinate beyond the stated noise {}\n",
                        lengthText(result.model_error, units), kFollowsNothing);
  for (const auto& alternative : result.alternatives) text += alternativeText(alternative, units);
  if (!result.ranking.empty())
    text += "  effect                                  probability  chi-square reduction   size\n";
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
    text += fmt::format("  set aside as an outlier: reading {}\n",
                        nameInLine(readings.at(static_cast<std::size_t>(reading)).id));
  for (const auto& lack : result.not_tried) text += "  not tried: " + lack + "\n";
  if (result.verdict == Verdict::kAdequate || result.verdict == Verdict::kInconclusive)
    text += detectableText(result, units);
  return text;
}

std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm, const Units& units) {
  return found.frees.empty() ? effectText(arm, found.fitted, units) : found.effect + "@" + found.at;
}

}  // namespace tubeplan::app
