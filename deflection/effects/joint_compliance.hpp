// Compliance of a joint axis that was modelled as rigid.
//
// Law: rotation = c M about the axis, at the row's origin (elements/joint_stiffness.hpp).
// Symbols: c compliance [rad/(N m)], M moment about the axis [N m].
// Validity: linear.
// Source: Calkins 1994, eq. 2.17.
#pragma once

#include <algorithm>
#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::joint_compliance {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  EffectTerms<S>& effect_terms = effectTermsOf(context, effect.place.row);
  effect_terms.joint_is_compliant = true;
  effect_terms.compliance[effect.place.axis] += effect.values[0];
}

inline bool hasPlace(const Arm& arm, int row, int axis) { return !std::isfinite(arm.rows[row].joint_stiffness[axis]); }

inline constexpr const char* kName = "joint-compliance";

/// Returns true if the arm has this effect at an axis of a row.
inline bool isAt(const Arm& arm, int row, int axis) {
  const Place place{.row = row, .axis = axis};
  return std::ranges::any_of(arm.effects, [&](const Effect& effect) {
    return effect.place == place && std::string_view(kindOf(effect).name) == kName;
  });
}

inline EffectKind kind() {
  return {.name = kName,
          .words = "a joint axis taken as rigid is compliant",
          .law = "rotation = compliance * moment about an axis taken as rigid",
          .validity = "linear",
          .source = "Calkins 1994, eq. 2.17",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kRowAxis,
          .odds = 2,
          .odds_reason = "bearings, gears and mounts are compliant: the first non-geometric error of loaded arms",
          .varies_with = {EffectVariable::kMoment},
          .needs = {.moments = true},
          .parameters = {{"compliance", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3}},
          .places = [](const Arm& arm) { return places::ofAxes(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::joint_compliance
