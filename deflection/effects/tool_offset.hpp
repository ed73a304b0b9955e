// An offset of the tip in the last row's frame.
//
// Law: tip = tip as drawn + v, in the last row's frame.
// Symbols: v offset [m].
// Validity: geometry only; a distributed weight extends to the new tip.
// Source: Klimchik et al. (arXiv 1211.5739), tool transformation.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::tool_offset {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  for (int k = 0; k < 3; ++k) context.arm.p_LT[k] += effect.values[k];
}

inline EffectKind kind() {
  return {.name = "tool-offset",
          .words = "the tip is offset in the last row's frame",
          .law = "tip = as drawn + (x, y, z) in the last row's frame",
          .validity = "geometry only",
          .source = "Klimchik et al., arXiv 1211.5739",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kWord,
          .word = "tool",
          .odds = 2,
          .odds_reason = "the tool is mounted and measured by hand",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"x", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02},
                         {"y", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02},
                         {"z", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::tool_offset
