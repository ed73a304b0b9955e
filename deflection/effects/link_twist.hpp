// A link that is twisted about its own length, so that its far joint axis is rotated relative to the drawing.
//
// Law: alpha to the next frame = alpha drawn + dalpha; for a row placed as in URDF, dalpha is added to the roll.
// Symbols: dalpha additional twist angle [rad].
// Validity: geometry only; every link but the last.
// Source: Denavit and Hartenberg 1955, as modified by Craig; Klimchik et al. (arXiv 1211.5739).
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::link_twist {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  Row<S>& next = context.arm.rows[effect.place.row + 1];
  if (auto* dh = std::get_if<DenavitHartenberg<S>>(&next.placement))
    dh->alpha += effect.values[0];
  else
    std::get<Origin<S>>(next.placement).rpy[0] += effect.values[0];
}

inline EffectKind kind() {
  return {.name = "link-twist",
          .words = "a link is twisted",
          .law = "twist alpha to the next frame = as drawn + twist",
          .validity = "geometry only; every link but the last",
          .source = "Denavit and Hartenberg 1955; Klimchik et al., arXiv 1211.5739",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kLink,
          .odds = 1,
          .odds_reason = "machined faces are square to tenths of a milliradian",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"twist", Quantity::kAngle, 0, -3.2, 3.2, 0.02}},
          .places =
              [](const Arm& arm) {
                return places::ofRows(arm,
                                      [](const Arm& a, int row) { return row + 1 < static_cast<int>(a.rows.size()); });
              },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_twist
