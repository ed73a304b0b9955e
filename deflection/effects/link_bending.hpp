// Bending of a member about an axis that was modelled as rigid.
//
// Law: curvature = b M about the row's axis projected perpendicular to the member (elements/beam.hpp); b = 1/(E I).
// Symbols: b bending compliance [1/(N m^2)], M moment about that axis [N m].
// Validity: as for the beam. A member bends about two axes, so the effect cannot act about the row's axis nearest to
//      the member's direction.
// Source: Calkins 1994, eq. 2.8 to 2.16.
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/elements/beam.hpp"

namespace tubeplan::deflection::link_bending {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.member_is_compliant = true;
  effect_terms.bends[effect.place.axis] = true;
  effect_terms.bending_compliance[effect.place.axis] += effect.values[0];
}

inline bool hasPlace(const Arm& arm, int row, int axis) {
  const auto& beam_of_row = arm.rows[row].beam;
  const Eigen::Vector3d member = undeflectedMember(arm, row);
  if (member.norm() < 1e-9 || (beam_of_row && beam::bends(*beam_of_row, axis))) return false;
  int nearest = 0;
  member.cwiseAbs().maxCoeff(&nearest);
  return axis != nearest;
}

inline EffectKind kind() {
  return {.name = "link-bending",
          .words = "a beam taken as rigid bends",
          .law = "curvature = compliance * moment about an axis in which the member was taken as rigid",
          .validity = "slender and linear; two axes of each member",
          .source = "Calkins 1994, eq. 2.8 to 2.16",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 1,
          .odds_reason = "slender members bend",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"compliance", Quantity::kPerBendingStiffness, 0, 0, kUnbounded, 5e-3}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_bending
