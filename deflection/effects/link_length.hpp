// A link longer or shorter than drawn.
//
// Law: a to the next frame = a drawn + dL; a row placed as in URDF is moved along its own position vector.
// Symbols: dL excess length [m].
// Validity: geometry only; a distributed weight grows with the length. Not for the last row: see tool-offset.
// Source: Denavit and Hartenberg 1955, as modified by Craig; Klimchik et al. (arXiv 1211.5739).
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::link_length {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  using std::sqrt;
  const Row<S>& given = context.given.rows[effect.place.row + 1];
  Row<S>& next = context.arm.rows[effect.place.row + 1];
  if (auto* dh = std::get_if<DenavitHartenberg<S>>(&next.placement)) {
    dh->a += effect.values[0];
    return;
  }
  const Vector3<S>& drawn = std::get<Origin<S>>(given.placement).position;
  std::get<Origin<S>>(next.placement).position += drawn * S(effect.values[0] / sqrt(drawn.squaredNorm()));
}

/// Returns true if the direction of the link's length is defined: the next frame is placed by Denavit-Hartenberg
/// parameters, or its origin differs from the link's own.
inline bool hasPlace(const Arm& arm, int row) {
  if (row + 1 == static_cast<int>(arm.rows.size())) return false;
  const auto* origin = std::get_if<Origin<double>>(&arm.rows[row + 1].placement);
  return !origin || origin->position.norm() > 1e-9;
}

inline EffectKind kind() {
  return {.name = "link-length",
          .words = "a link is longer or shorter than drawn",
          .law = "distance a to the next frame = as drawn + length",
          .validity = "geometry only; every link but the last",
          .source = "Denavit and Hartenberg 1955; Klimchik et al., arXiv 1211.5739",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kLink,
          .odds = 1,
          .odds_reason = "a drawing is right to tenths of a millimetre",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"length", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.005}},
          .places = [](const Arm& arm) { return places::ofRows(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::link_length
