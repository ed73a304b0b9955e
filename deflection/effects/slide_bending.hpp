// A prismatic joint that is more compliant the farther it is extended, because less of its bar lies within the guide.
//
// Law: rotation = M (c1 s + c2 s^2 + c3 s^3) about the axis, at the guide.
// Symbols: s extension: if limits are stated, the reading above the lower limit, divided by the range; else the reading
//      in metres; c1 to c3 [rad/(N m)] at s = 1; M moment about the axis at the guide [N m].
// Validity: small rotations; readings that grow as the bar is extended. The compliance at s = 0 is joint-compliance.
// Source: two bearings separated by the overlap L - s have a compliance proportional to 1 / (L - s)^2, whose series in
//      s / L has no negative term; the series is taken to third order.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::slide_bending {

inline bool hasPlace(const Arm& arm, int row, int axis) {
  return arm.rows[row].joint.type == JointType::kPrismatic && axis < 2;
}

template <class S>
bool hasRange(const Joint<S>& joint) {
  return std::isfinite(joint.upper - joint.lower) && joint.upper > joint.lower;
}

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int row = effect.place.row;
  const auto& joint = context.given.rows[row].joint;
  const S reading = context.nominal_posture.q[jointIndexOf(context.given, row)];
  const S along = hasRange(joint) ? S((reading - S(joint.lower)) / S(joint.upper - joint.lower)) : reading;
  const S out = along > S(0) ? along : S(0);  // a fully retracted bar has no such compliance
  EffectTerms<S>& effect_terms = effectTermsOf(context, row);
  effect_terms.joint_is_compliant = true;
  effect_terms.compliance[effect.place.axis] +=
      out * (effect.values[0] + out * (effect.values[1] + out * effect.values[2]));
}

inline EffectKind kind() {
  return {.name = "slide-bending",
          .words = "a slide is more compliant the farther it is extended",
          .law = "rotation at its guide = moment there * (linear * s + square * s^2 + cube * s^3), s its extension",
          .validity = "small rotations; s over the range of the limits, or in metres where none are stated",
          .source = "bearings an overlap apart, to third order",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 1,
          .odds_reason = "telescopes are more compliant the farther they are extended",
          .varies_with = {EffectVariable::kMoment, EffectVariable::kJoint},
          .needs = {.moments = true},
          .parameters = {{"linear", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3},
                         {"square", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3},
                         {"cube", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::slide_bending
