// A link whose two joint axes, nominally almost parallel, are tilted relative to each other.
//
// Law: the next row's frame is rotated by dbeta about its own y axis, before its joint rotates it.
// Symbols: dbeta lean angle [rad].
// Validity: geometry only; links whose far axis is parallel to their near axis within 30 degrees. For other links,
//      link-twist, link-length and joint-offset together place the axis.
// Source: Hayati and Mirmirani 1985 (the parameter beta of nearly parallel axes).
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::deflection::link_lean {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  Row<S>& next = context.arm.rows[effect.place.row + 1];
  S& beta = dhOf(next) ? dhOf(next)->beta : originOf(next)->beta;
  beta += effect.values[0];
}

/// Returns true if the next row rotates about an axis that is nearly parallel to this row's axis.
inline bool hasPlace(const Arm& arm, int row) {
  return row + 1 < static_cast<int>(arm.rows.size()) && turns(arm.rows[row + 1].joint) &&
         isNearlyParallel(arm.rows[row + 1]);
}

inline EffectKind kind() {
  return {.name = "link-lean",
          .words = "a joint axis leans out of parallel",
          .law = "frame of the next link = as drawn, turned by lean about its own y",
          .validity = "geometry only; where two joint axes are drawn parallel, within 30 degrees",
          .source = "Hayati and Mirmirani 1985",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kLink,
          .place_needs = "two joint axes that follow each other and are nearly parallel",
          .odds = 1,
          .odds_reason = "bores are parallel to tenths of a milliradian",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"lean", Quantity::kAngle, 0, -3.2, 3.2, 0.02}},
          .places = [](const Arm& arm) { return places::ofRows(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_lean
