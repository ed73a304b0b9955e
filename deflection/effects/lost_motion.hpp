// Lost motion of a gear: a joint that the arm file takes as rigid and that is more compliant under small moments.
//
// Law: rotation = c clamp(M, -M1, M1) about the joint's axis, in addition to that of the effect joint-compliance
//      (elements/joint_stiffness.hpp).
// Symbols: c additional compliance below the knee [rad/(N m)], M1 knee moment [N m], M moment about the axis [N m].
// Validity: two branches; elastic, the same in both directions.
// Source: catalogues of gears: lost motion of cycloidal reducers; K1, K2 and T1 of Harmonic Drive.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::lost_motion {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.joint_is_compliant = true;
  effect_terms.soft_compliance[effect.place.axis] += effect.values[0];
  effect_terms.knee[effect.place.axis] += effect.values[1];
}

inline bool hasPlace(const Arm& arm, int row, int axis) {
  const Row<double>& r = arm.rows[row];
  return axis == 2 && r.joint.type == JointType::kRevolute && !std::isfinite(r.joint_stiffness[axis]);
}

inline EffectKind kind() {
  return {.name = "lost-motion",
          .words = "a joint taken as rigid is more compliant under small moments than under larger ones",
          .law = "rotation = compliance * clamp(moment, -knee, knee) about the joint's axis",
          .validity = "two elastic branches, the same both ways",
          .source = "catalogues of gears: lost motion; Harmonic Drive's K1, K2, T1",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .place_needs = "a revolute joint without joint_stiffness about its axis in the arm file",
          .extends = "joint-compliance",
          .odds = 1,
          .odds_reason = "gears are compliant about zero, where few teeth or rollers carry",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"compliance", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3},
                         {"knee", Quantity::kTorque, 20, 0, kUnbounded, 500, true}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::lost_motion
