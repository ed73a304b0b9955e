// An arm at one posture with all its effects applied: the solver's input instead of the bare arm.
//
// Every effect reads the given arm and posture and adds to the copies, so that effects combine in any number and order.
#pragma once

#include <optional>

#include "deflection/effects/rigid_frames.hpp"
#include "deflection/effects/rigid_moment.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

template <class S>
struct EffectContext {
  EffectContext(const ArmOf<S>& given_arm, const PostureOf<S>& given_posture)
      : given(given_arm), nominal_posture(given_posture) {}

  const ArmOf<S>& given;  ///< nominal arm, read by the effects
  /// Nominal posture: encoder readings, gravity in the axes of the nominal base.
  const PostureOf<S>& nominal_posture;
  /// Copy of the arm that effects modify; its own list of effects is empty.
  ArmOf<S> arm;
  /// Actual posture: true joint values, gravity in the axes of the moved base.
  PostureOf<S> posture;
  Vector3<S> gravity_turn = Vector3<S>::Zero();  ///< rotation vector by which effects tilt gravity, in base axes [rad]
  PoseOf<S> X_BM;                                ///< pose of the moved base M in the nominal base
  S measurement_scale{1};                        ///< ratio of measured to true coordinates
  std::optional<RigidFrames<S>> rigid_frames;    ///< undeflected frames, computed on demand
  /// Moments on the rows of the undeflected arm, computed when an effect first needs them.
  std::optional<std::vector<Vector3<S>>> rigid_moments;
  /// Reason why an effect has no finite value at this posture; empty if all values are finite.
  std::string undefined = {};
};

/// Resets the copies of arm and posture, and applies the arm's effects to them. Earlier content is overwritten in
/// place.
template <class S>
void applyEffects(EffectContext<S>& context);

/// Returns the context of an arm at a posture, with the arm's effects applied. `arm` and `posture` must outlive the
/// result.
template <class S>
[[nodiscard]] EffectContext<S> contextOf(const ArmOf<S>& arm, const PostureOf<S>& posture);

/// Returns the ratio of measured to true coordinates: 1 without a scale error.
[[nodiscard]] double measurementScale(const Arm& arm);
[[nodiscard]] Dual measurementScale(const ArmOf<Dual>& arm);

/// Returns the undeflected row frames of the given arm, computed once for all effects.
template <class S>
const RigidFrames<S>& rigidFramesOf(EffectContext<S>& context) {
  if (!context.rigid_frames) context.rigid_frames = rigidFramesOf<S>(context.given, context.nominal_posture.q);
  return *context.rigid_frames;
}

/// Returns the moment on a row of the undeflected arm, about the row's origin and in its axes [N m].
template <class S>
const Vector3<S>& rigidMomentOf(EffectContext<S>& context, int row) {
  if (!context.rigid_moments) context.rigid_moments = rigidMoments<S>(context.given, context.nominal_posture);
  return (*context.rigid_moments)[static_cast<std::size_t>(row)];
}

/// Returns the effect terms of a row; adds them if there are none.
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
