// A joint driven by cables: the cables stretch under the moment, and friction adds a rotation whose sign depends on the
// direction of the last motion.
//
// Law: rotation = c M + k |M| s, with M the moment about the joint's axis.
// Symbols: c stretch [rad/(N m)]; k contribution of friction [rad/(N m)]; s direction of the joint's last motion, -1, 0
//      or +1; M moment in the undeflected shape [N m].
// Validity: linear stretch; the last motion was longer than the lost motion.
// Source: capstan friction: a cable over a sheave loses a fraction of its tension (Townsend and Salisbury 1987).
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/effects/rigid_moment.hpp"

namespace tubeplan::deflection::cable_stretch {

inline bool hasPlace(const Arm& arm, int row) {
  return arm.rows[row].joint.type == JointType::kRevolute && !std::isfinite(arm.rows[row].joint_stiffness[2]);
}

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int row = effect.place.row, joint = jointIndexOf(context.given, row);
  const S moment = rigidMomentOf(context, row)[2];
  const auto& approach_directions = context.nominal_posture.approach_directions;
  const double approach_direction = approach_directions.empty() ? 0 : approach_directions[joint];
  using std::abs;
  context.posture.q[joint] += effect.values[0] * moment + effect.values[1] * abs(moment) * S(approach_direction);
}

inline EffectKind kind() {
  return {.name = "cable-stretch",
          .words = "a joint's cable stretches with torque and direction",
          .law = "rotation = stretch * moment + friction * |moment| * direction of the last motion",
          .validity = "linear stretch; the last motion was longer than the lost motion",
          .source = "Townsend and Salisbury 1987, capstan friction in cable drives",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kJoint,
          .odds = 0.5,
          .odds_reason = "cable-driven arms only",
          .varies_with = {EffectVariable::kMoment, EffectVariable::kDirection},
          .needs = {.approach_directions = true, .moments = true},
          .parameters = {{"stretch", Quantity::kAnglePerTorque, 0, 0, kUnbounded, 1e-3},
                         {"friction", Quantity::kAnglePerTorque, 0, -kUnbounded, kUnbounded, 5e-4}},
          .places = [](const Arm& arm) { return places::ofRows(arm, hasPlace); },
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::cable_stretch
