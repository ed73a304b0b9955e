// A hung load whose centre is not at the tip.
//
// Law: the load acts at tip + v, a point that rotates with the deflected tool: a couple (R v) x F in addition to the
//      force.
// Symbols: v offset [m] in the last row's axes at the tip, R rotation of these axes on the deflected arm, F hung load
//      [N].
// Validity: the load is held rigidly; the tool's own weight is not displaced.
// Source: statics.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::payload_offset {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  TipLoad<S>& load = tipLoadOf(context);
  for (int k = 0; k < 3; ++k) load.payload_offset[k] += effect.values[k];
}

inline EffectKind kind() {
  return {.name = "payload-offset",
          .words = "the payload's centre is off the tip",
          .law = "the hung load acts at tip + (x, y, z) in the last row's frame",
          .validity = "a load rigidly held; the tool's own weight is unchanged",
          .source = "statics",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kWord,
          .word = "payload",
          .odds = 1,
          .odds_reason = "loads hang where a hook is, not at the tip",
          .varies_with = {EffectVariable::kLoad},
          .needs = {.load = true},
          .parameters = {{"x", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.3},
                         {"y", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.3},
                         {"z", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.3}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::payload_offset
