// A tool frame that is rotated in the last row's frame: a probe or a tracker target mounted on the tool by hand.
//
// Law: axes of the tool frame = exp(turn drawn + v) times the axes drawn, in the last row's frame. The tip does not
//      move.
// Symbols: v additional rotation vector [rad].
// Validity: geometry only; observable in measured rotations of the tool and in points of the tool away from its tip.
//      The axis along which the tool enters a hole does not rotate with the tool frame.
// Source: Everett 1987 (six parameters of a mechanism's tool, three of them for the tip).
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::tool_turn {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  for (int k = 0; k < 3; ++k) context.arm.tool_turn_L[k] += effect.values[k];
}

inline EffectKind kind() {
  return {.name = "tool-turn",
          .words = "the tool frame is turned in the last row's frame",
          .law = "tool frame = as drawn, turned by the rotation vector (x, y, z) in the last row's frame",
          .validity = "geometry only; seen by readings of the tool's turn and of points beside its tip",
          .source = "Everett 1987",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kWord,
          .word = "tool",
          .odds = 2,
          .odds_reason = "the target for the tool's turn is mounted by hand",
          .varies_with = {EffectVariable::kJoint},
          .needs = {.tool_turn = true},
          .parameters = {{"x", Quantity::kAngle, 0, -kFullTurn, kFullTurn, 0.1},
                         {"y", Quantity::kAngle, 0, -kFullTurn, kFullTurn, 0.1},
                         {"z", Quantity::kAngle, 0, -kFullTurn, kFullTurn, 0.1}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::tool_turn
