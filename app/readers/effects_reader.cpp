#include "app/readers/effects_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

Effect parseEffect(const std::string& text, const deflection::Arm& arm, const std::string& where) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos)
    throw InputError(where, inQuotes(text), "EFFECT@AT, as backlash@tool.z", "`tubeplan effects CELL` lists them");
  const auto made = deflection::makeEffect(arm, text.substr(0, at), text.substr(at + 1));
  if (made.status == EffectStatus::kMade) return made.effect;
  const bool is_effect = made.status == EffectStatus::kUnknownEffect;
  throw InputError(where, inQuotes(text) + " (" + made.reason + ")",
                   made.known.empty() ? "an effect this arm can have"
                                      : fmt::format("one of {}", fmt::join(made.known, ", ")),
                   suggestion(is_effect ? text.substr(0, at) : text.substr(at + 1), made.known));
}

}  // namespace tubeplan::app
