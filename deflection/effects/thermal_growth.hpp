// Links that grow with temperature.
//
// Law: length = length drawn (1 + x (T - T0)), for a, b and d or the position of every row after the first row with a
//      joint, and for the tip.
// Symbols: x expansion [1/K], T the posture's temperature [K], T0 the arm's reference temperature [K].
// Validity: one temperature and one expansion for the whole arm; readings of prismatic joints do not grow. Parts before
//      the first joint belong to the base.
// Source: linear thermal expansion; 2.3e-5 1/K for aluminium, 1.2e-5 for steel.
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::thermal_growth {

template <class S>
void grow(const Row<S>& given, Row<S>& row, const S& strain) {
  if (auto* dh = std::get_if<DenavitHartenberg<S>>(&row.placement)) {
    const auto& drawn = std::get<DenavitHartenberg<S>>(given.placement);
    dh->a += drawn.a * strain;
    dh->b += drawn.b * strain;
    dh->d += drawn.d * strain;
  } else {
    std::get<Origin<S>>(row.placement).position += std::get<Origin<S>>(given.placement).position * strain;
  }
}

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const double temperature = context.nominal_posture.conditions[Condition::kTemperature];
  if (std::isnan(temperature)) return;
  const S strain = effect.values[0] * (temperature - context.given.reference[Condition::kTemperature]);
  bool moves = false;
  for (std::size_t i = 0; i < context.given.rows.size(); ++i) {
    const Row<S>& given = context.given.rows[i];
    if (moves) grow(given, context.arm.rows[i], strain);
    moves = moves || given.joint.type != JointType::kPassive;
  }
  context.arm.p_LT += context.given.p_LT * strain;
}

inline EffectKind kind() {
  return {.name = "thermal-growth",
          .words = "lengths grow with temperature",
          .law = "moving lengths = as drawn * (1 + expansion * (temperature - reference_temperature))",
          .validity = "one temperature and one expansion for the whole arm",
          .source = "linear thermal expansion",
          .stage = EffectStage::kGeometry,
          .at = PlaceRule::kWord,
          .word = "arm",
          .odds = 1,
          .odds_reason = "halls warm by some degrees during a shift",
          .varies_with = {Condition::kTemperature},
          .needs = {},
          .parameters = {{"expansion", Quantity::kPerTemperature, 0, -0.01, 0.01, 1e-4}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::thermal_growth
