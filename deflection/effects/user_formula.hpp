// A law written by a user: TARGET += EXPRESSION.
//
// Law: as written (effects/formula.hpp).
// Symbols: the symbols and the parameters of the formula.
// Validity: where the expression has a finite value; other postures are not solved.
// Source: the user.
#pragma once

#include <cmath>

#include "deflection/effects/formula.hpp"
#include "deflection/effects/places.hpp"
#include "deflection/effects/rigid_moment.hpp"

namespace tubeplan::deflection::user_formula {

inline constexpr const char* kName = "formula";

/// Returns the value of a symbol in the units of the formula.
template <class S>
S valueOf(const FormulaSymbol& symbol, EffectContext<S>& context) {
  const ArmOf<S>& given = context.given;
  const PostureOf<S>& nominal_posture = context.nominal_posture;
  using Of = FormulaSymbol::Of;
  const auto inUnit = [&](const S& internal) { return internal / symbol.unit - S(symbol.zero); };
  switch (symbol.of) {
    case Of::kJoint:
      return inUnit(nominal_posture.q[jointIndexOf(given, symbol.row)]);
    case Of::kApproachDirection:
      return nominal_posture.approach_directions.empty()
                 ? S(0)
                 : S(nominal_posture.approach_directions[jointIndexOf(given, symbol.row)]);
    case Of::kMoment:
      return inUnit(rigidMomentOf(context, symbol.row)[symbol.axis]);
    case Of::kLoad:
      return inUnit(nominal_posture.load);
    case Of::kCondition: {
      const double stated = nominal_posture.conditions[symbol.condition];
      return inUnit(S(std::isnan(stated) ? given.reference[symbol.condition] : stated));
    }
  }
  return S(0);
}

/// Returns the arguments of the expression, in the order of its names.
template <class S>
std::vector<S> inputsOf(const EffectOf<S>& effect, EffectContext<S>& context) {
  std::vector<S> at;
  for (const Formula::Input& input : effect.formula->inputs)
    at.push_back(input.parameter < 0 ? valueOf(input.symbol, context)
                                     : S(effect.values[input.parameter] / effect.formula->units[input.parameter]));
  return at;
}

std::string undefinedText(const Formula& formula, const std::vector<double>& at);

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const Formula& formula = *effect.formula;
  const std::vector<S> at = inputsOf(effect, context);
  const S added = formula.expression->value(at) * formula.unit;
  if constexpr (std::is_same_v<S, double>)
    if (!std::isfinite(added)) context.undefined = undefinedText(formula, at);
  const FormulaTarget& target = formula.target;
  switch (target.of) {
    case FormulaTarget::Of::kJoint:
      context.posture.q[jointIndexOf(context.given, target.row)] += added;
      return;
    case FormulaTarget::Of::kTip:
      context.arm.p_LT[target.axis] += added;
      return;
    case FormulaTarget::Of::kBase:
      if (target.axis < 3)
        context.X_BM.p[target.axis] += added;
      else
        context.X_BM.R = context.X_BM.R * rotationZ<S>(added);
  }
}

/// Returns the kind of user-defined effects. It lists no places in an arm, because a formula names its own target.
inline EffectKind kind() {
  return {.name = kName,
          .words = "a user-defined formula",
          .law = "TARGET += EXPRESSION, as the user writes it",
          .validity = "where the expression has a finite value",
          .source = "the user",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJoint,
          .places_elsewhere = "the formula's target: a joint, tip.x to tip.z, base.x to base.z, base.yaw",
          .odds = 0,
          .odds_reason = "a user's formula is tried only on request",
          .varies_with = {},
          .needs = {},
          .parameters = {},
          .places = [](const Arm&) { return std::vector<Place>(); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::user_formula
