// Torsion of a member that was modelled as rigid.
//
// Law: twist per length = t M about the member (elements/beam.hpp); t = 1/(G J).
// Symbols: t torsion compliance [1/(N m^2)], M moment about the member [N m].
// Validity: uniform torsion (Saint-Venant).
// Source: Calkins 1994, eq. 2.16.
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/elements/beam.hpp"

namespace tubeplan::deflection::link_torsion {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.member_is_compliant = true;
  effect_terms.torsion_compliance += effect.values[0];
}

inline bool hasPlace(const Arm& arm, int row) {
  const auto& beam_of_row = arm.rows[row].beam;
  return undeflectedMember(arm, row).norm() >= 1e-9 && !(beam_of_row && beam::twists(*beam_of_row));
}

inline EffectKind kind() {
  return {.name = "link-torsion",
          .words = "a beam taken as rigid twists",
          .law = "twist per length = compliance * moment about a member taken as rigid in torsion",
          .validity = "uniform torsion",
          .source = "Calkins 1994, eq. 2.16",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kLink,
          .odds = 1,
          .odds_reason = "members with eccentric loads twist",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"compliance", Quantity::kPerBendingStiffness, 0, 0, kUnbounded, 5e-3}},
          .places = [](const Arm& arm) { return places::ofRows(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_torsion
