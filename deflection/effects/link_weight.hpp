// A link that is heavier or lighter than stated; the difference acts at its end.
//
// Law: weight at the link's end = as stated + w.
// Symbols: w additional weight [N], at least minus the link's whole weight.
// Validity: at rest.
// Source: Calkins 1994, section 2.3 (end weights).
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::deflection::link_weight {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  context.arm.rows[effect.place.row].weight.end += effect.values[0];
}

/// Returns the lower bound of the added weight [N]: a link cannot lose more than its end weight, lumps and distributed
/// weight.
inline double least(const Arm& arm, const Place& place) {
  return -rowWeightOf(arm, static_cast<std::size_t>(place.row)).weight;
}

inline EffectKind kind() {
  return {.name = "link-weight",
          .words = "a link weighs more or less",
          .law = "weight at the link's end = as stated + weight",
          .validity = "at rest",
          .source = "Calkins 1994, section 2.3",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kLink,
          .odds = 1,
          .odds_reason = "cables and fittings are seldom in the weights of a drawing",
          .varies_with = {EffectVariable::kJoint, EffectVariable::kMoment},
          .needs = {},
          .parameters = {{.name = "weight",
                          .quantity = Quantity::kForce,
                          .neutral = 0,
                          .lower = -kUnbounded,
                          .upper = kUnbounded,
                          .plausible = 100,
                          .least = least}},
          .places = [](const Arm& arm) { return places::ofRows(arm); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_weight
