#include "deflection/effects/effect_context.hpp"

#include "deflection/effects/effect.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::deflection {

namespace {

template <class S>
void applyOne(const EffectKind& kind, const EffectOf<S>& effect, EffectContext<S>& context) {
  if constexpr (std::is_same_v<S, double>)
    kind.apply(effect, context);
  else
    kind.applyDual(effect, context);
}

/// Copies an arm without its effects.
template <class S>
void copyWithoutEffects(const ArmOf<S>& from, ArmOf<S>& to) {
  to.gravity_W = from.gravity_W;
  to.rows = from.rows;
  to.p_LT = from.p_LT;
  to.tool_axis_L = from.tool_axis_L;
  to.R_LT = from.R_LT;
  to.tool_turn_L = from.tool_turn_L;
  to.reference = from.reference;
  to.tip_load = from.tip_load;
}

/// Removes the flexibility of rows that the posture's set-up declares rigid. An example is the flexible mounting of an
/// arm that is now bolted to a bench.
template <class S>
void makeMountingRigid(EffectContext<S>& context) {
  for (const RigidMounting& mounting : context.given.mountings) {
    if (mounting.setup != context.nominal_posture.setup) continue;
    for (const int index : mounting.rows) {
      Row<S>& row = context.arm.rows[static_cast<std::size_t>(index)];
      row.joint_stiffness.setConstant(S(kRigid));
      row.beam.reset();
      row.effect_terms.reset();
    }
  }
}

/// Adds the posture's wrench to the loads on the tip, in the axes of the moved base.
template <class S>
void applyWrench(EffectContext<S>& context) {
  if (!context.posture.wrench) return;
  WrenchOf<S>& wrench = *context.posture.wrench;
  wrench.force_B = (context.X_BM.R.transpose() * wrench.force_B).eval();
  wrench.moment_B = (context.X_BM.R.transpose() * wrench.moment_B).eval();
  TipLoad<S>& load = tipLoadOf(context);
  load.force += wrench.force_B;
  load.moment += wrench.moment_B;
}

template <class S>
S scaleOf(const ArmOf<S>& arm) {
  const PostureOf<S> nowhere;
  EffectContext<S> context(arm, nowhere);
  const auto& kinds = effectKinds();
  for (const auto& effect : arm.effects)
    if (kinds.at(effect.kind).stage == EffectStage::kMeasurement) applyOne(kinds[effect.kind], effect, context);
  return context.measurement_scale;
}

}  // namespace

template <class S>
void applyEffects(EffectContext<S>& context) {
  copyWithoutEffects(context.given, context.arm);
  context.posture = context.nominal_posture;
  context.gravity_turn.setZero();
  context.X_BM = {};
  context.measurement_scale = S(1);
  context.rigid_frames.reset();
  context.rigid_moments.reset();
  context.undefined.clear();
  const auto& kinds = effectKinds();
  for (const auto& effect : context.given.effects) applyOne(kinds.at(effect.kind), effect, context);
  makeMountingRigid(context);
  const Vector3<S> gravity_B = rotationFromVector<S>(context.gravity_turn) * context.nominal_posture.gravity_B;
  context.posture.gravity_B = context.X_BM.R.transpose() * gravity_B;
  applyWrench(context);
  attachSideChains<S>(context.given, context.nominal_posture, context.arm);
}

template <class S>
EffectContext<S> contextOf(const ArmOf<S>& arm, const PostureOf<S>& posture) {
  EffectContext<S> context(arm, posture);
  applyEffects(context);
  return context;
}

template void applyEffects(EffectContext<double>&);
template void applyEffects(EffectContext<Dual>&);
template EffectContext<double> contextOf(const ArmOf<double>&, const PostureOf<double>&);
template EffectContext<Dual> contextOf(const ArmOf<Dual>&, const PostureOf<Dual>&);

double measurementScale(const Arm& arm) { return scaleOf(arm); }
Dual measurementScale(const ArmOf<Dual>& arm) { return scaleOf(arm); }

}  // namespace tubeplan::deflection
