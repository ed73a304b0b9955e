#include "deflection/effects/situation.hpp"

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

namespace {

template <class S>
void applyOne(const EffectKind& kind, const EffectOf<S>& effect, Situation<S>& situation) {
  if constexpr (std::is_same_v<S, double>)
    kind.apply(effect, situation);
  else
    kind.applyDual(effect, situation);
}

/// All of the arm but its effects.
template <class S>
ArmOf<S> withoutEffects(const ArmOf<S>& arm) {
  return {arm.name, arm.gravity_W, arm.rows, arm.p_LT, arm.tool_axis_L, arm.reference_temperature, {}, arm.tip_load};
}

template <class S>
S scaleOf(const ArmOf<S>& arm) {
  const PostureOf<S> nowhere;
  Situation<S> situation{arm, nowhere, {}, {}, Vector3<S>::Zero(), {}, S(1)};
  const auto& kinds = effectKinds();
  for (const auto& effect : arm.effects)
    if (kinds.at(effect.kind).stage == EffectStage::kMeasurement) applyOne(kinds[effect.kind], effect, situation);
  return situation.measurement_scale;
}

}  // namespace

template <class S>
Situation<S> situationOf(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  Situation<S> situation{arm, posture, withoutEffects(arm), posture, Vector3<S>::Zero(), {}, S(1)};
  const auto& kinds = effectKinds();
  for (const auto& effect : arm.effects) applyOne(kinds.at(effect.kind), effect, situation);
  const Vector3<S> gravity_B = rotationFromVector<S>(situation.gravity_turn) * posture.gravity_B;
  situation.posture.gravity_B = situation.X_BM.R.transpose() * gravity_B;
  return situation;
}

template Situation<double> situationOf(const ArmOf<double>&, const PostureOf<double>&);
template Situation<Dual> situationOf(const ArmOf<Dual>&, const PostureOf<Dual>&);

double measurementScale(const Arm& arm) { return scaleOf(arm); }
Dual measurementScale(const ArmOf<Dual>& arm) { return scaleOf(arm); }

}  // namespace tubeplan::deflection
