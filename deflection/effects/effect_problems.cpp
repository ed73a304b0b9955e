// Checks of an arm's effects: kinds, places, values and repetitions.
#include <algorithm>
#include <cmath>
#include <set>

#include "deflection/effects/user_formula.hpp"

namespace tubeplan::deflection {

namespace {

/// Returns true if an arm has all rows that a formula refers to.
bool fits(const Arm& arm, const Formula& formula) {
  const auto active = activeRows(arm);
  const auto isJoint = [&](int row) { return std::find(active.begin(), active.end(), row) != active.end(); };
  if (formula.target.of == FormulaTarget::Of::kJoint && !isJoint(formula.target.row)) return false;
  return std::all_of(formula.inputs.begin(), formula.inputs.end(), [&](const Formula::Input& input) {
    const FormulaSymbol& symbol = input.symbol;
    const bool of_joint = symbol.of == FormulaSymbol::Of::kJoint || symbol.of == FormulaSymbol::Of::kApproachDirection;
    return input.parameter >= 0 || (of_joint ? isJoint(symbol.row) : symbol.row < static_cast<int>(arm.rows.size()));
  });
}

bool isWhereItCanBe(const Arm& arm, const EffectKind& kind, const Effect& effect) {
  if (effect.formula) return kind.name == std::string_view(user_formula::kName) && fits(arm, *effect.formula);
  if (kind.at == PlaceRule::kSetup) return !effect.place.setup.empty();
  const auto all = kind.places(arm);
  return std::find(all.begin(), all.end(), effect.place) != all.end();
}

void checkValues(const Arm& arm, const Effect& effect, std::vector<ArmProblem>& out) {
  const auto& parameters = numbersOf(effect);
  const std::string name = textOf(arm, effect);
  if (effect.values.size() != parameters.size()) {
    out.push_back({name, std::to_string(effect.values.size()) + " numbers", std::to_string(parameters.size())});
    return;
  }
  for (int k = 0; k < static_cast<int>(parameters.size()); ++k) {
    const EffectNumber number = numberOf(arm, effect, k);
    const double value = effect.values[k];
    const std::string path = name + "." + parameters[k].name;
    if (!std::isfinite(value))
      out.push_back({path, std::to_string(value), "a finite number"});
    else if (value < number.lower || value > number.upper)
      out.push_back({path, value < 0 && number.lower == 0 ? "a negative number" : std::to_string(value),
                     number.lower == 0 ? "zero or more, in its physical range" : "a value in its physical range"});
  }
}

}  // namespace

std::vector<ArmProblem> findEffectProblems(const Arm& arm) {
  std::vector<ArmProblem> out;
  std::set<std::string> names;
  for (std::size_t k = 0; k < arm.effects.size(); ++k) {
    const Effect& effect = arm.effects[k];
    const std::string path = std::string("effects.") + std::to_string(k + 1);
    if (effect.kind < 0 || effect.kind >= static_cast<int>(effectKinds().size())) {
      out.push_back({path, "the effect is not in the catalogue"});
      continue;
    }
    const EffectKind& kind = kindOf(effect);
    if (!isWhereItCanBe(arm, kind, effect)) {
      out.push_back({path, std::string("this arm has no such place for the effect ") + kind.name});
      continue;
    }
    const std::string name = textOf(arm, effect);
    if (!names.insert(name).second) out.push_back({name, "the effect is listed twice at this place"});
    checkValues(arm, effect, out);
  }
  return out;
}

}  // namespace tubeplan::deflection
