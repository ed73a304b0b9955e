// One posture of an arm with all its effects applied: what the solver is given instead of the bare arm.
//
// Every effect reads the arm and the posture as given and adds to the copies, so effects compose in any number and in
// any order.
#pragma once

#include <optional>

#include "deflection/effects/rigid_frames.hpp"
#include "deflection/effects/rigid_moment.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

template <class S>
struct EffectContext {
  EffectContext(const ArmOf<S>& given_arm, const PostureOf<S>& asked_posture)
      : given(given_arm), asked(asked_posture) {}

  const ArmOf<S>& given;                         ///< as the file has it: what effects read
  const PostureOf<S>& asked;                     ///< readings as the encoders show them, gravity in the base as named
  ArmOf<S> arm;                                  ///< what effects add to; carries no effects itself
  PostureOf<S> posture;                          ///< true joint values, gravity as the moved base sees it
  Vector3<S> gravity_turn = Vector3<S>::Zero();  ///< rotation vector that turns gravity, base axes [rad]
  PoseOf<S> X_BM;                                ///< the base as moved, M, in the base as named
  S measurement_scale{1};                        ///< measured coordinates per true one
  std::optional<RigidFrames<S>> rigid_frames;    ///< of `given` at `asked`, once an effect has asked for them
  std::optional<std::vector<Vector3<S>>> rigid_moments;  ///< the same
  std::string undefined = {};  ///< why an effect has no finite value here; empty where all have
};

/// Begins the copies anew and applies the arm's effects. What a situation held before is overwritten in place.
template <class S>
void applyEffects(EffectContext<S>& context);

/// The arm's effects applied at a posture. `arm` and `posture` must outlive the result.
template <class S>
[[nodiscard]] EffectContext<S> contextOf(const ArmOf<S>& arm, const PostureOf<S>& posture);

/// Measured coordinates per true one: 1 without a scale error.
[[nodiscard]] double measurementScale(const Arm& arm);
[[nodiscard]] Dual measurementScale(const ArmOf<Dual>& arm);

/// Where the given arm stands as if nothing gave; effects share it.
template <class S>
const RigidFrames<S>& rigidFramesOf(EffectContext<S>& context) {
  if (!context.rigid_frames) context.rigid_frames = rigidFramesOf<S>(context.given, context.asked.q);
  return *context.rigid_frames;
}

/// The moment on a row as if nothing gave.
template <class S>
const Vector3<S>& rigidMomentOf(EffectContext<S>& context, int row) {
  if (!context.rigid_moments) context.rigid_moments = rigidMoments<S>(context.given, context.asked);
  return (*context.rigid_moments)[static_cast<std::size_t>(row)];
}

/// The additions of a row, begun where there are none.
template <class S>
EffectTerms<S>& effectTermsOf(EffectContext<S>& context, int row) {
  auto& effect_terms = context.arm.rows[row].effect_terms;
  if (!effect_terms) effect_terms.emplace();
  return *effect_terms;
}

template <class S>
TipLoad<S>& tipLoadOf(EffectContext<S>& context) {
  auto& load = context.arm.tip_load;
  if (!load) load.emplace();
  return *load;
}

}  // namespace tubeplan::deflection
