// A contact force on the tip.
//
// Law: a constant force f at the tip, against gravity.
// Symbols: f force [N], positive upwards.
// Validity: a probe or support that exerts the same force in every measurement.
// Source: statics.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::contact_force {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  tipLoadOf(context).contact_force += effect.values[0];
}

inline EffectKind kind() {
  return {.name = "contact-force",
          .words = "a contact force acts on the tip",
          .law = "a constant force at the tip, against gravity",
          .validity = "the same in every reading",
          .source = "statics",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kWord,
          .word = "tip",
          .odds = 1,
          .odds_reason = "a touching tool exerts a force",
          .varies_with = {EffectVariable::kJoint, EffectVariable::kMoment},
          .needs = {},
          .parameters = {{"force", Quantity::kForce, 0, -kUnbounded, kUnbounded, 200}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::contact_force
