// Gravity tilted relative to the nominal pose of the base.
//
// Law: the direction of gravity is rotated by the rotation vector (wx, wy, 0) in base axes; the geometry is unchanged.
// Symbols: wx, wy components of the rotation vector [rad].
// Validity: angles far below one radian, so that the order of the two rotations does not matter. A rotation about
//      gravity itself has no effect.
// Source: statics; the tilt of an instrument's vertical axis in levelling.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::gravity_tilt {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  context.gravity_turn.x() += effect.values[0];
  context.gravity_turn.y() += effect.values[1];
}

inline EffectKind kind() {
  return {.name = "gravity-tilt",
          .words = "gravity is tilted in the base frame",
          .law = "gravity turned by the rotation vector (x, y, 0) in base axes",
          .validity = "angles far below a radian",
          .source = "statics",
          .stage = EffectStage::kLoad,
          .at = PlaceRule::kWord,
          .word = "base",
          .odds = 0.5,
          .odds_reason = "a floor is level to a milliradian, which hardly shows",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"x", Quantity::kAngle, 0, -0.5, 0.5, 0.05}, {"y", Quantity::kAngle, 0, -0.5, 0.5, 0.05}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::gravity_tilt
