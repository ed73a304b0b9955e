// Clearance of a joint, taken up in the direction of the moment.
//
// Law: rotation +g/2 where the moment is positive, -g/2 where it is negative, free in between (elements/clearance.hpp).
// Symbols: g gap [rad].
// Validity: at rest, without friction; about compliant axes, about any axis of a row with a revolute joint (its
//      bearings also have transverse play) and about both axes perpendicular to a prismatic joint (its bar tilts in the
//      guide).
// Source: Signorini's complementarity; coupling backlash in Harmonic Drive's catalogues.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::backlash {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.joint_is_compliant = true;
  effect_terms.has_gap[effect.place.axis] = true;
  effect_terms.gap[effect.place.axis] += effect.values[0];
}

inline bool hasPlace(const Arm& arm, int row, int axis) {
  const Row<double>& r = arm.rows[row];
  return std::isfinite(r.joint_stiffness[axis]) || r.joint.type == JointType::kRevolute ||
         (r.joint.type == JointType::kPrismatic && axis < 2);
}

inline EffectKind kind() {
  return {.name = "backlash",
          .words = "a joint has backlash, taken up in the direction of the moment",
          .law = "rotation = half the gap in the direction of the moment, undetermined where the moment is zero",
          .validity = "static, without friction",
          .source = "complementarity; Harmonic Drive catalogues, backlash",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 1.5,
          .odds_reason = "couplings, latches and pins have clearance",
          .varies_with = {EffectVariable::kMoment},
          .needs = {},
          .parameters = {{"gap", Quantity::kAngle, 0, 0, 1.6, 0.02}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::backlash
