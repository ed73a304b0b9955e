// A tool heavier or lighter than stated, in the same proportion everywhere.
//
// Law: every weight of the last row = weight as stated * (1 + e).
// Symbols: e relative error of the weights [1], at least -1.
// Validity: at rest; the hung load is not included.
// Source: Calkins 1994, section 2.3 (weight per length, end weights).
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::tool_weight {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const Weight<S>& given = context.given.rows.back().weight;
  Weight<S>& weight = context.arm.rows.back().weight;
  const S& e = effect.values[0];
  weight.distributed += given.distributed * e;
  weight.end += given.end * e;
  for (std::size_t k = 0; k < weight.lumps.size(); ++k) weight.lumps[k].weight += given.lumps[k].weight * e;
}

inline EffectKind kind() {
  return {.name = "tool-weight",
          .words = "the tool weighs more or less",
          .law = "weights of the last row = as stated * (1 + scale)",
          .validity = "static; without the hung load",
          .source = "Calkins 1994, section 2.3",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kWord,
          .word = "tool",
          .odds = 1,
          .odds_reason = "tools are changed and seldom weighed",
          .varies_with = {EffectVariable::kJoint, EffectVariable::kMoment},
          .needs = {},
          .parameters = {{"scale", Quantity::kNone, 0, -1, kUnbounded, 0.5}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::tool_weight
