#include "app/documents/effect_catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/effect_words_json.hpp"
#include "app/documents/figures.hpp"
#include "app/formats/units_json.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Returns the parameters of an effect with their neutral values and bounds, in the units that apply where the effect
/// acts.
json parametersJson(const Cell& cell, const deflection::EffectKind& kind, const deflection::Effect& effect) {
  json parameters = json::array();
  for (std::size_t v = 0; v < kind.parameters.size(); ++v) {
    const auto number = deflection::numberOf(cell.arm, effect, static_cast<int>(v));
    const Dimension unit = dimensionOf(number.quantity);
    const auto bound = [&](double value) {
      return std::isfinite(value) ? json(cell.units.toFile(value, unit)) : json();
    };
    parameters.push_back({{"name", kind.parameters[v].name},
                          {"unit", cell.units.nameOf(unit)},
                          {"neutral", bound(kind.parameters[v].neutral)},
                          {"low", bound(number.lower)},
                          {"high", bound(number.upper)},
                          {"plausible", bound(kind.parameters[v].plausible)}});
  }
  return parameters;
}

/// Returns the parameters of an effect at the place `at`, such as "gap (deg, usually up to 1.15)".
std::string numbersText(const Cell& cell, const deflection::EffectKind& kind, const std::string& at) {
  std::vector<std::string> numbers;
  for (const json& number : parametersJson(cell, kind, deflection::makeEffect(cell.arm, kind.name, at).effect)) {
    const json& most = number["plausible"];
    numbers.push_back(fmt::format("{} ({}{})", number["name"].get<std::string>(), number["unit"].get<std::string>(),
                                  most.is_null() ? "" : fmt::format(", usually up to {:.3g}", most.get<double>())));
  }
  return fmt::format("{}", fmt::join(numbers, ", "));
}

std::string placesText(const Cell& cell, const deflection::EffectKind& kind) {
  if (*kind.places_elsewhere) return fmt::format("at: {}", kind.places_elsewhere);
  const auto places = deflection::placeTexts(cell.arm, kind);
  if (places.empty()) return deflection::lackOfPlace(kind);
  return fmt::format("numbers: {}\n  at: {}", numbersText(cell, kind, places.front()), fmt::join(places, ", "));
}

}  // namespace

json catalogueJson(const Cell& cell) {
  json effects = json::array();
  for (const auto& kind : deflection::effectKinds())
    for (const auto& at : deflection::placeTexts(cell.arm, kind)) {
      const auto made = deflection::makeEffect(cell.arm, kind.name, at);
      if (made.status != deflection::EffectStatus::kMade) continue;
      effects.push_back({{"effect", kind.name},
                         {"at", at},
                         {"law", kind.law},
                         {"validity", kind.validity},
                         {"source", kind.source},
                         {"parameters", parametersJson(cell, kind, made.effect)}});
      addEffectWords(kind.name, effects.back());
    }
  return {{"units", unitsJson(cell.units)}, {"effects", effects}};
}

std::string catalogueText(const Cell& cell, const std::string& only) {
  std::string text;
  for (const auto& kind : deflection::effectKinds()) {
    if (!only.empty() && only != kind.name) continue;
    text += fmt::format("{}\n  {}\n  {}\n", kind.name, kind.words, kind.law);
    text += fmt::format("  {}\n", placesText(cell, kind));
  }
  return text;
}

}  // namespace tubeplan::app
