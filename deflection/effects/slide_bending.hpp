// A slide that gives the more the farther it is out: less of it overlaps its bearing.
//
// Law: rotation = M (c1 s + c2 s^2) about the axis, at the slide's end; M the moment there.
// Symbols: s how far the slide is out of its lower limit [m], over its range; c1, c2 [rad/(N m)] at full range; M
// moment about the axis of the shape without deflection [N m].
// Validity: small rotations; a range that is stated.
// Source: two bearings an overlap L apart give by 1 / L^2 under a moment, taken to second order in s.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::slide_bending {

inline bool hasPlace(const Arm& arm, int row, int axis) {
  const auto& joint = arm.rows[row].joint;
  return joint.type == JointType::kPrismatic && axis < 2 && std::isfinite(joint.upper - joint.lower) &&
         joint.upper > joint.lower;
}

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int row = effect.place.row;
  const auto& joint = context.given.rows[row].joint;
  const S out = (context.asked.q[jointIndexOf(context.given, row)] - S(joint.lower)) / S(joint.upper - joint.lower);
  EffectTerms<S>& effect_terms = effectTermsOf(context, row);
  effect_terms.joint_is_compliant = true;
  effect_terms.compliance[effect.place.axis] += effect.values[0] * out + effect.values[1] * out * out;
}

inline EffectKind kind() {
  return {.name = "slide-bending",
          .words = "a slide bends the more the further it is out",
          .law = "rotation at a slide's end = moment * (linear * s + square * s^2), s how far it is out",
          .validity = "small rotations; the slide's limits are stated",
          .source = "bearings an overlap apart, to second order",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 1,
          .odds_reason = "telescopes are softer the farther they are out",
          .varies_with = {EffectVariable::kMoment, EffectVariable::kJoint},
          .needs = {.moments = true},
          .parameters = {{"linear", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3},
                         {"square", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::slide_bending
