// A joint that is more compliant under small moments than beyond a knee moment, as a harmonic drive is in torsion.
//
// Law: rotation = (M + s clamp(M, -M1, M1)) / K, with K the axis's own stiffness, which applies on the stiff branch
//      (elements/joint_stiffness.hpp). The soft branch has the stiffness K1 = K / (1 + s). The effect lost-motion does
//      the same for an axis that the arm file takes as rigid.
// Symbols: s softness [1], M1 knee moment [N m], M moment about the axis [N m].
// Validity: two branches; elastic, the same in both directions. Where the moment always exceeds the knee, the effect is
//      only a constant rotation.
// Source: Harmonic Drive catalogues, torsional stiffness K1, K2 and T1.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::stiffening {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.joint_is_compliant = true;
  effect_terms.softness[effect.place.axis] += effect.values[0];
  effect_terms.knee[effect.place.axis] += effect.values[1];
}

inline bool hasPlace(const Arm& arm, int row, int axis) { return std::isfinite(arm.rows[row].joint_stiffness[axis]); }

inline EffectKind kind() {
  return {.name = "stiffening",
          .words = "a joint is compliant under small moments and stiffer under larger ones",
          .law = "rotation = (moment + softness * clamp(moment, -knee, knee)) / joint_stiffness",
          .validity = "two elastic branches, the same both ways",
          .source = "Harmonic Drive catalogues: K1, K2, T1",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .place_needs = "an axis with joint_stiffness in the arm file",
          .odds = 1,
          .odds_reason = "strain wave gears and preloaded bearings are compliant about zero",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"softness", Quantity::kNone, 0, 0, kUnbounded, 10},
                         {"knee", Quantity::kTorque, 20, 0, kUnbounded, 500, true}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::stiffening
