// Compliance of a joint axis that was modelled as rigid.
//
// Law: rotation = c M about the axis, at the row's origin (elements/joint_stiffness.hpp).
// Symbols: c compliance [rad/(N m)], M moment about the axis [N m].
// Validity: linear.
// Source: Calkins 1994, eq. 2.17.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::joint_compliance {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.joint_is_compliant = true;
  effect_terms.compliance[effect.place.axis] += effect.values[0];
}

inline bool hasPlace(const Arm& arm, int row, int axis) { return !std::isfinite(arm.rows[row].joint_stiffness[axis]); }

inline EffectKind kind() {
  return {.name = "joint-compliance",
          .words = "a joint axis taken as rigid is compliant",
          .law = "rotation = compliance * moment about an axis taken as rigid",
          .validity = "linear",
          .source = "Calkins 1994, eq. 2.17",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 2,
          .odds_reason = "bearings, gears and mounts are compliant: the first non-geometric error of loaded arms",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"compliance", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::joint_compliance
