// A scale error of the measuring instrument.
//
// Law: measured coordinate = (1 + e) * true world coordinate.
// Symbols: e relative error of the scale [1].
// Validity: all coordinates are measured by one instrument in the world frame; the arm itself does not change.
// Source: calibration of length-measuring instruments.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::scale_error {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  context.measurement_scale += effect.values[0];
}

inline EffectKind kind() {
  return {.name = "scale-error",
          .words = "the measuring scale is off",
          .law = "measured coordinate = true one * (1 + scale)",
          .validity = "one instrument in the world frame; nothing of the arm",
          .source = "calibration of length measuring instruments",
          .stage = EffectStage::kMeasurement,
          .at = PlaceRule::kWord,
          .word = "measurement",
          .odds = 0.5,
          .odds_reason = "instruments are calibrated far better than arms",
          .varies_with = {EffectVariable::kPosition},
          .needs = {},
          .parameters = {{"scale", Quantity::kNone, 0, -0.5, 0.5, 0.005}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::scale_error
