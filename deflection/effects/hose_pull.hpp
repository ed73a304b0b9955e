// A hose or cable that pulls on a link.
//
// Law: a constant force (x, y, z) at the link's end, in base axes.
// Symbols: x, y, z components of the force [N].
// Validity: the hose is long enough that its pull does not depend on the posture or the deflection.
// Source: statics.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::hose_pull {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  for (int k = 0; k < 3; ++k) effect_terms.end_force[k] += effect.values[k];
}

inline EffectKind kind() {
  return {.name = "hose-pull",
          .words = "a hose or cable pulls at a link",
          .law = "a constant force (x, y, z) at the link's end, in base axes",
          .validity = "a long hose: the posture does not change its pull",
          .source = "statics",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kLink,
          .odds = 1,
          .odds_reason = "hoses and cables drag",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"x", Quantity::kForce, 0, -kUnbounded, kUnbounded, 100},
                         {"y", Quantity::kForce, 0, -kUnbounded, kUnbounded, 100},
                         {"z", Quantity::kForce, 0, -kUnbounded, kUnbounded, 100}},
          .places = [](const Arm& arm) { return places::ofRows(arm); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::hose_pull
