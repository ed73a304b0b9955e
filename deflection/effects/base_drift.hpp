// A base that drifts with time.
//
// Law: the base is shifted by rate * time.
// Symbols: rate [m/s] in base axes, time [s] as stated in the measurements.
// Validity: creep proportional to time. A measurement without a time is treated as undrifted.
// Source: rigid body.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::base_drift {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const double time = context.nominal_posture.conditions[Condition::kTime];
  if (std::isnan(time)) return;
  for (int k = 0; k < 3; ++k) context.X_BM.p[k] += effect.values[k] * time;
}

inline EffectKind kind() {
  return {.name = "base-drift",
          .words = "the base drifts with time",
          .law = "the base is shifted by (x, y, z) * time",
          .validity = "creep in proportion to time",
          .source = "rigid body",
          .stage = EffectStage::kBase,
          .at = PlaceRule::kWord,
          .word = "base",
          .odds = 0.5,
          .odds_reason = "creep of a mount is slow",
          .varies_with = {Condition::kTime},
          .needs = {},
          .parameters = {{"x", Quantity::kSpeed, 0, -kUnbounded, kUnbounded, 1e-6},
                         {"y", Quantity::kSpeed, 0, -kUnbounded, kUnbounded, 1e-6},
                         {"z", Quantity::kSpeed, 0, -kUnbounded, kUnbounded, 1e-6}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::base_drift
