// Lost motion: the joint stops on one or the other side of its reading, depending on the direction of its last motion.
//
// Law: true joint value = reading + h s.
// Symbols: h half width [rad; m for a prismatic joint], s direction of the joint's last motion, -1, 0 or +1.
// Validity: the joint moved further than its lost motion before it stopped. An unknown direction is treated as 0.
// Source: Coulomb friction before a spring; lost motion in Harmonic Drive's catalogues.
#pragma once

#include <cassert>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::hysteresis {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const auto& approach_directions = context.nominal_posture.approach_directions;
  if (approach_directions.empty()) return;
  const int joint = jointIndexOf(context.given, effect.place.row);
  assert(joint < static_cast<int>(approach_directions.size()));
  context.posture.q[joint] += effect.values[0] * static_cast<double>(approach_directions[joint]);
}

inline EffectKind kind() {
  return {.name = "hysteresis",
          .words = "a joint's position depends on the direction of its last motion",
          .law = "true joint value = reading + half_width * direction of the last motion",
          .validity = "the last motion was longer than the lost motion",
          .source = "Coulomb friction; Harmonic Drive catalogues, lost motion",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJoint,
          .odds = 1.5,
          .odds_reason = "every gear and seal has friction before a spring",
          .varies_with = {EffectVariable::kDirection},
          .needs = {.approach_directions = true},
          .parameters = {{"half_width", Quantity::kAngle, 0, -0.5, 0.5, 0.01}},
          .places = places::ofJoints,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::hysteresis
