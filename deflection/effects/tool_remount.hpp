// A tool or target that was remounted: in one set-up, the tip's position in the last row's frame differs from that in
// the other set-ups.
//
// Law: in the named set-up, tip in the last row's frame = tip in the other set-ups + (x, y, z).
// Symbols: x, y, z components of the offset [m].
// Validity: rigid; constant throughout the set-up.
// Source: geometry; a known error of measurement campaigns with several set-ups.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::tool_remount {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  if (context.nominal_posture.setup != effect.place.setup) return;
  context.arm.p_LT += Vector3<S>(effect.values[0], effect.values[1], effect.values[2]);
}

inline EffectKind kind() {
  return {.name = "tool-remount",
          .words = "the tip was remounted for a set-up",
          .law = "in one set-up the tip is offset: tip = that of the others + (x, y, z) in the last row's frame",
          .validity = "rigid, the same all through the set-up",
          .source = "geometry",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kSetup,
          .places_elsewhere = "a set-up of the readings, by its name",
          .odds = 2,
          .odds_reason = "tools and targets are removed and remounted between set-ups",
          .varies_with = {EffectVariable::kSetup},
          .needs = {},
          .parameters = {{"x", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.01},
                         {"y", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.01},
                         {"z", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.01}},
          .places = [](const Arm&) { return std::vector<Place>{}; },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::tool_remount
