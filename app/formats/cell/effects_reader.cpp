#include "app/formats/cell/effects_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/formats/quantities.hpp"
#include "app/formats/unit_names.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::app {

namespace {

using deflection::Effect, deflection::EffectKind, deflection::EffectStatus;

constexpr const char* kFormula = "formula";

std::string withoutDigits(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  return text;
}

/// Returns a question such as "did you mean 'theta1'?" if a parameter's name may be a misspelt symbol; otherwise empty.
/// Names of one or two letters resemble every symbol, so they are reported only if they differ from a symbol in digits
/// alone.
std::string misspeltSymbol(const std::string& name, const std::vector<std::string>& symbols) {
  const bool is_short = name.size() < 3;
  std::vector<std::string> candidates;
  for (const auto& symbol : symbols)
    if (!is_short || withoutDigits(symbol) == withoutDigits(name)) candidates.push_back(symbol);
  return suggestion(name, candidates);
}

/// Throws InputError for an invalid formula, and for a name in it that looks like a misspelt symbol.
void requireFormula(const deflection::MadeFormula& made, const deflection::Arm& arm, const Units& units,
                    const std::string& where) {
  std::vector<std::string> symbols;
  for (const auto& named : deflection::formulaSymbols(arm, formulaUnitsOf(units))) symbols.push_back(named.name);
  for (const auto& name : made.free)
    if (const auto meant = misspeltSymbol(name, symbols); !meant.empty())
      throw InputError::problem(
          where, fmt::format("the name {} is neither a symbol nor a parameter with an initial value", inQuotes(name)),
          meant + " If the name is a parameter, give it an initial value: '; " + name.substr(0, 60) + "=0'");
  if (made.status == deflection::FormulaStatus::kMade) return;
  std::string advice = suggestion(made.word, made.known);
  if (advice.empty() && made.status == deflection::FormulaStatus::kBadTarget && !made.known.empty())
    advice = fmt::format("the targets are {}", fmt::join(made.known, ", "));
  throw InputError(where, made.found, made.expected, advice);
}

/// Returns an effect with its initial parameters: a formula, or an effect of the catalogue.
Effect effectAtStart(const YamlNode& node, const deflection::Arm& arm, const Units& units) {
  if (node.at("effect").text() == kFormula) {
    const YamlNode& text = node.at(kFormula);
    const YamlNode* at = node.find("at");
    const auto made = deflection::makeFormula(arm, text.text(), formulaUnitsOf(units), at ? at->text() : "");
    requireFormula(made, arm, units, text.where());
    return made.effect;
  }
  const auto made = deflection::makeEffect(arm, node.at("effect").text(), node.at("at").text());
  if (made.status == EffectStatus::kUnknownEffect)
    node.at("effect").fail("the unknown effect " + inQuotes(node.at("effect").text()), "an effect of the catalogue",
                           suggestion(node.at("effect").text(), made.known));
  if (made.status != EffectStatus::kMade)
    throw placeError(node.at("at").where(), made, node.at("effect").text(), node.at("at").text());
  return made.effect;
}

Effect readEffect(const YamlNode& node, const deflection::Arm& arm, const Units& units) {
  Effect effect = effectAtStart(node, arm, units);
  std::vector<std::string> numbers;
  for (const auto& parameter : deflection::numbersOf(effect)) numbers.emplace_back(parameter.name);
  if (effect.formula) {
    std::vector<std::string> optional = numbers;
    optional.emplace_back("at");
    node.expectKeys({"effect", kFormula}, optional);
  } else {
    node.expectKeys({"effect", "at"}, numbers);
  }
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

/// Returns the size of a unit written behind a number [internal units]: the file's unit if none is written;
/// std::nullopt if it is none of this dimension.
std::optional<double> factorOfWritten(const std::string& written, Dimension unit, const Units& units) {
  if (written.empty()) return units.factor(unit);
  const auto given = convertedUnit(written, TargetUnits::si()),
             expected = convertedUnit(units.nameOf(unit), TargetUnits::si());
  if (!given || !expected || given->name != expected->name) return std::nullopt;
  return units.factor(unit) * given->factor / expected->factor;
}

/// Reads a number such as "0.15deg"; without a unit it is in the file's unit.
double readSize(const std::string& text, double lower, double upper, Dimension unit, const Units& units,
                const std::string& where) {
  std::size_t used = 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const auto factor = factorOfWritten(text.substr(used), unit, units);
  if (used == 0 || !std::isfinite(value) || !factor)
    throw InputError(where, inQuotes(text), "a number in " + units.nameOf(unit), "");
  const double internal = value * *factor;
  if (internal < lower || internal > upper)
    throw InputError(where, inQuotes(text),
                     fmt::format("a number from {} to {} {}", formatNumber(units.toFile(lower, unit)),
                                 formatNumber(units.toFile(upper, unit)), units.nameOf(unit)),
                     "");
  return internal;
}

/// Reads the parameters of an effect from "0.15deg" or "softness=0.6,knee=200".
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
      throw InputError(where, "the unknown number " + inQuotes(name), fmt::format("one of {}", fmt::join(names, ", ")),
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

deflection::FormulaUnits formulaUnitsOf(const Units& units) {
  deflection::FormulaUnits of{units.factor(dimension::kLength), units.factor(dimension::kAngle),
                              units.factor(dimension::kForce)};
  for (const auto& kind : deflection::kConditionKinds)
    of.conditions[kind.condition] = {units.factor(dimensionOf(kind.unit.quantity)), -units.toFile(0, kind.unit)};
  return of;
}

std::vector<Effect> readEffects(const YamlNode& node, const deflection::Arm& arm, const Units& units) {
  std::vector<Effect> effects;
  deflection::Arm with = arm;  // formulas without a place continue the numbering of parameters of earlier effects
  for (const YamlNode& item : node.list()) {
    with.effects = effects;
    Effect effect = readEffect(item, with, units);
    const bool is_twice = std::any_of(effects.begin(), effects.end(), [&](const Effect& other) {
      return deflection::textOf(arm, other) == deflection::textOf(arm, effect);
    });
    if (is_twice)
      item.failWithProblem(deflection::textOf(arm, effect) + " is listed twice",
                           "list each effect only once for each place");
    effects.push_back(std::move(effect));
  }
  return effects;
}

namespace {

/// Returns the parameters of an effect as strings in the cell's units: "gap: 0.12", "knee: 200".
std::vector<std::string> numbersText(const deflection::Arm& arm, const Effect& effect, const Units& units,
                                     const char* between) {
  std::vector<std::string> numbers;
  for (std::size_t v = 0; v < effect.values.size(); ++v) {
    const Dimension unit = dimensionOf(deflection::numberOf(arm, effect, static_cast<int>(v)).quantity);
    numbers.push_back(fmt::format("{}{}{}", deflection::numbersOf(effect)[v].name, between,
                                  formatNumber(units.toFile(effect.values[v], unit))));
  }
  return numbers;
}

}  // namespace

std::string effectText(const deflection::Arm& arm, const Effect& effect, const Units& units) {
  if (effect.formula) return effect.formula->text;
  return fmt::format("{}:{}", deflection::textOf(arm, effect), fmt::join(numbersText(arm, effect, units, "="), ","));
}

std::string effectsText(const deflection::Arm& arm, const Units& units) {
  std::vector<std::string> items;
  for (const Effect& effect : arm.effects) {
    const EffectKind& kind = kindOf(effect);
    std::string item = fmt::format("{{effect: {}, at: \"{}\"", kind.name, deflection::placeText(arm, effect));
    // The formula needs no escapes: it contains neither quotes nor backslashes.
    if (effect.formula) item += fmt::format(", {}: \"{}\"", kFormula, effect.formula->text);
    for (const auto& number : numbersText(arm, effect, units, ": ")) item += ", " + number;
    items.push_back(item + "}");
  }
  return fmt::format("[{}]", fmt::join(items, ", "));
}

Effect parseFormula(const std::string& text, const deflection::Arm& arm, const Units& units, const std::string& where,
                    const std::string& at) {
  const auto made = deflection::makeFormula(arm, text, formulaUnitsOf(units), at);
  requireFormula(made, arm, units, where);
  return made.effect;
}

std::string formulaUnitsText(const deflection::Arm& arm, const Effect& formula, const Units& units) {
  std::string conditions;
  for (const auto& kind : deflection::kConditionKinds)
    conditions += fmt::format(", {} in {}", kind.name, units.nameOf(kind.unit));
  return fmt::format("{}: joints in rad, lengths in {}, load in {}{}; its value in {}",
                     deflection::placeText(arm, formula), units.length().name, units.force().name, conditions,
                     units.nameOf(dimensionOf(formula.formula->quantity)));
}

InputError placeError(const std::string& where, const deflection::MadeEffect& made, const std::string& name,
                      const std::string& at) {
  if (made.known.empty())
    return InputError::problem(
        where, fmt::format("the effect {} cannot be placed at {}: {}", name, inQuotes(at), made.reason));
  const std::string near = suggestion(at, made.known);
  return InputError::problem(
      where, fmt::format("this arm has no place {} for the effect {}", inQuotes(at), name),
      fmt::format("choose one of {}{}{}", fmt::join(made.known, ", "), near.empty() ? "" : "; ", near));
}

ParsedEffect parseEffect(const std::string& text, const deflection::Arm& arm, const Units& units,
                         const std::string& where) {
  if (text.find("+=") != std::string::npos) return {parseFormula(text, arm, units, where), true};
  const std::size_t at = text.find('@');
  if (at == std::string::npos)
    throw InputError(where, inQuotes(text), "an effect and its place, EFFECT@AT, such as backlash@tool.z",
                     "`tubeplan effects CELL` lists the choices");
  const std::size_t colon = text.find(':', at);
  const std::string name = text.substr(0, at), place = text.substr(at + 1, colon - at - 1);
  const auto made = deflection::makeEffect(arm, name, place);
  if (made.status == EffectStatus::kUnknownEffect)
    throw InputError(where, "the unknown effect " + inQuotes(name),
                     fmt::format("one of {}", fmt::join(made.known, ", ")), suggestion(name, made.known));
  if (made.status != EffectStatus::kMade) throw placeError(where, made, name, place);
  ParsedEffect parsed{made.effect, colon != std::string::npos};
  if (parsed.has_sizes) readSizes(text.substr(colon + 1), arm, units, where, parsed.effect);
  return parsed;
}

}  // namespace tubeplan::app
