#include "app/readers/effects_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/input_error.hpp"
#include "app/readers/quantities.hpp"
#include "app/suggestion.hpp"

namespace tubeplan::app {

namespace {

using deflection::Effect, deflection::EffectKind, deflection::EffectStatus;

const EffectKind& kindOf(const Effect& effect) {
  return deflection::effectKinds().at(static_cast<std::size_t>(effect.kind));
}

Effect readEffect(const YamlNode& node, const deflection::Arm& arm, const Units& units) {
  const auto made = deflection::makeEffect(arm, node.at("effect").text(), node.at("at").text());
  if (made.status == EffectStatus::kUnknownEffect)
    node.at("effect").fail("the unknown effect " + inQuotes(node.at("effect").text()), "an effect of the catalogue",
                           suggestion(node.at("effect").text(), made.known));
  if (made.status != EffectStatus::kMade)
    node.at("at").fail("the place " + inQuotes(node.at("at").text()) + ": " + made.reason,
                       made.known.empty() ? "another arm" : fmt::format("one of {}", fmt::join(made.known, ", ")),
                       suggestion(node.at("at").text(), made.known));
  Effect effect = made.effect;
  std::vector<std::string> numbers;
  for (const auto& parameter : kindOf(effect).parameters) numbers.emplace_back(parameter.name);
  node.expectKeys({"effect", "at"}, numbers);
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const auto number = deflection::numberOf(arm, effect, static_cast<int>(v));
    effect.values[v] = readQuantityOr(node, numbers[v], units, dimensionOf(number.quantity), effect.values[v]);
    if (effect.values[v] >= number.lower && effect.values[v] <= number.upper) continue;
    const Dimension unit = dimensionOf(number.quantity);
    node.at(numbers[v])
        .fail(node.at(numbers[v]).scalar,
              fmt::format("a number from {} to {} {}", formatNumber(units.toFile(number.lower, unit)),
                          formatNumber(units.toFile(number.upper, unit)), units.nameOf(unit)),
              "");
  }
  return effect;
}

/// "0.15deg": a number and, if it likes, the unit it must have.
double readSize(const std::string& text, double lower, double upper, Dimension unit, const Units& units,
                const std::string& where) {
  std::size_t used = 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string written = text.substr(used);
  if (used == 0 || !std::isfinite(value) || (!written.empty() && written != units.nameOf(unit)))
    throw InputError(where, inQuotes(text), "a number in " + units.nameOf(unit), "");
  const double internal = units.toInternal(value, unit);
  if (internal < lower || internal > upper)
    throw InputError(where, inQuotes(text),
                     fmt::format("a number from {} to {} {}", formatNumber(units.toFile(lower, unit)),
                                 formatNumber(units.toFile(upper, unit)), units.nameOf(unit)),
                     "");
  return internal;
}

/// "0.15deg" or "softness=0.6,knee=200".
void readSizes(const std::string& text, const deflection::Arm& arm, const Units& units, const std::string& where,
               Effect& effect) {
  std::vector<std::string> names;
  for (const auto& parameter : kindOf(effect).parameters) names.emplace_back(parameter.name);
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, to - from);
    const std::size_t equals = part.find('=');
    const std::string name = equals == std::string::npos ? names.front() : part.substr(0, equals);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError(where, "no number " + inQuotes(name), fmt::format("one of {}", fmt::join(names, ", ")),
                       suggestion(name, names));
    const int value = static_cast<int>(found - names.begin());
    const auto number = deflection::numberOf(arm, effect, value);
    effect.values[static_cast<std::size_t>(value)] =
        readSize(equals == std::string::npos ? part : part.substr(equals + 1), number.lower, number.upper,
                 dimensionOf(number.quantity), units, where);
    from = to + 1;
  }
}

}  // namespace

std::vector<Effect> readEffects(const YamlNode& node, const deflection::Arm& arm, const Units& units) {
  std::vector<Effect> effects;
  for (const YamlNode& item : node.list()) {
    Effect effect = readEffect(item, arm, units);
    const bool is_twice = std::any_of(effects.begin(), effects.end(), [&](const Effect& other) {
      return other.kind == effect.kind && other.place == effect.place;
    });
    if (is_twice) item.fail(deflection::textOf(arm, effect) + " again", "every effect once at a place", "");
    effects.push_back(std::move(effect));
  }
  return effects;
}

std::string effectsText(const deflection::Arm& arm, const Units& units) {
  std::vector<std::string> items;
  for (const Effect& effect : arm.effects) {
    const EffectKind& kind = kindOf(effect);
    std::string item = fmt::format("{{effect: {}, at: \"{}\"", kind.name, deflection::textOf(arm, kind, effect.place));
    for (std::size_t v = 0; v < effect.values.size(); ++v) {
      const Dimension unit = dimensionOf(deflection::numberOf(arm, effect, static_cast<int>(v)).quantity);
      item += fmt::format(", {}: {}", kind.parameters[v].name, formatNumber(units.toFile(effect.values[v], unit)));
    }
    items.push_back(item + "}");
  }
  return fmt::format("[{}]", fmt::join(items, ", "));
}

ParsedEffect parseEffect(const std::string& text, const deflection::Arm& arm, const Units& units,
                         const std::string& where) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos)
    throw InputError(where, inQuotes(text), "EFFECT@AT, as backlash@tool.z", "`tubeplan effects CELL` lists them");
  const std::size_t colon = text.find(':', at);
  const auto made = deflection::makeEffect(arm, text.substr(0, at), text.substr(at + 1, colon - at - 1));
  if (made.status != EffectStatus::kMade) {
    const bool is_effect = made.status == EffectStatus::kUnknownEffect;
    throw InputError(
        where, inQuotes(text) + " (" + made.reason + ")",
        made.known.empty() ? "an effect this arm can have" : fmt::format("one of {}", fmt::join(made.known, ", ")),
        suggestion(is_effect ? text.substr(0, at) : text.substr(at + 1, colon - at - 1), made.known));
  }
  ParsedEffect parsed{made.effect, colon != std::string::npos};
  if (parsed.has_sizes) readSizes(text.substr(colon + 1), arm, units, where, parsed.effect);
  return parsed;
}

}  // namespace tubeplan::app
