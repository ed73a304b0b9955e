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
void copyWithoutEffects(const ArmOf<S>& from, ArmOf<S>& to) {
  to.gravity_W = from.gravity_W;
  to.rows = from.rows;
  to.p_LT = from.p_LT;
  to.tool_axis_L = from.tool_axis_L;
  to.reference_temperature = from.reference_temperature;
  to.tip_load = from.tip_load;
}

/// An arm that is bolted to a bench leaves the rows of its mounting as rigid as that.
template <class S>
void makeMountingRigid(Situation<S>& situation) {
  for (const RigidMounting& mounting : situation.given.mountings) {
    if (mounting.setup != situation.asked.setup) continue;
    for (const int index : mounting.rows) {
      Row<S>& row = situation.arm.rows[static_cast<std::size_t>(index)];
      row.joint_stiffness.setConstant(S(kRigid));
      row.beam.reset();
      row.addition.reset();
    }
  }
}

template <class S>
S scaleOf(const ArmOf<S>& arm) {
  const PostureOf<S> nowhere;
  Situation<S> situation(arm, nowhere);
  const auto& kinds = effectKinds();
  for (const auto& effect : arm.effects)
    if (kinds.at(effect.kind).stage == EffectStage::kMeasurement) applyOne(kinds[effect.kind], effect, situation);
  return situation.measurement_scale;
}

}  // namespace

template <class S>
void applyEffects(Situation<S>& situation) {
  copyWithoutEffects(situation.given, situation.arm);
  situation.posture = situation.asked;
  situation.gravity_turn.setZero();
  situation.X_BM = {};
  situation.measurement_scale = S(1);
  situation.rigid_frames.reset();
  situation.rigid_moments.reset();
  situation.undefined.clear();
  const auto& kinds = effectKinds();
  for (const auto& effect : situation.given.effects) applyOne(kinds.at(effect.kind), effect, situation);
  makeMountingRigid(situation);
  const Vector3<S> gravity_B = rotationFromVector<S>(situation.gravity_turn) * situation.asked.gravity_B;
  situation.posture.gravity_B = situation.X_BM.R.transpose() * gravity_B;
}

template <class S>
Situation<S> situationOf(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  Situation<S> situation(arm, posture);
  applyEffects(situation);
  return situation;
}

template void applyEffects(Situation<double>&);
template void applyEffects(Situation<Dual>&);
template Situation<double> situationOf(const ArmOf<double>&, const PostureOf<double>&);
template Situation<Dual> situationOf(const ArmOf<Dual>&, const PostureOf<Dual>&);

double measurementScale(const Arm& arm) { return scaleOf(arm); }
Dual measurementScale(const ArmOf<Dual>& arm) { return scaleOf(arm); }

}  // namespace tubeplan::deflection
