// A compliant joint under weights that the arm file does not state, described by three products of compliance and
// weight.
//
// Law: rotation about the joint's axis z = z . [(x u_x + y u_y) + (p_T - p_J) w / (1 m)] x g.
// Symbols: x, y the row's axes perpendicular to z; u_x, u_y rotation [rad] due to the weight of the link itself while x
//      or y is horizontal; w rotation [rad] due to the weight at the tip while the tip is level with the joint and 1 m
//      away; p_T, p_J positions of tip and joint [m]; g direction of gravity.
// Validity: linear, in the undeflected shape. If the arm's weights are stated, joint stiffness describes the same sag.
// Source: compliance times the first moment of mass, as base parameters of gravity: Gautier and Khalil 1990, "Direct
//      calculation of minimum set of inertial parameters of serial robots".
#pragma once

#include "deflection/effects/places.hpp"
#include "deflection/effects/rigid_frames.hpp"

namespace tubeplan::deflection::gravity_sag {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int row = effect.place.row;
  const RigidFrames<S>& frames = rigidFramesOf(context);
  const PoseOf<S>& joint = frames.rows[row];
  const Vector3<S> lever =
      joint.R.col(0) * effect.values[0] + joint.R.col(1) * effect.values[1] + (frames.tip - joint.p) * effect.values[2];
  const Vector3<S> moment = lever.cross(context.nominal_posture.gravity_B);
  context.posture.q[jointIndexOf(context.given, row)] += joint.R.col(2).dot(moment);
}

inline EffectKind kind() {
  return {.name = "gravity-sag",
          .words = "a joint sags under weights that the arm file does not state",
          .law =
              "rotation of a joint = its moment by unknown weights: the joint's own part, horizontal along x and along "
              "y, and the part at the tip",
          .validity = "linear; the arm's weights need not be stated",
          .source = "Gautier and Khalil 1990, base parameters of gravity",
          .stage = EffectStage::kFlexibility,
          .at = PlaceRule::kJoint,
          .odds = 2,
          .odds_reason = "every drive is compliant, and few makers state weights",
          .varies_with = {EffectVariable::kJoint, EffectVariable::kMoment},
          .needs = {.no_weights = true},
          .parameters = {{"own_x", Quantity::kAngle, 0, -0.5, 0.5, 0.005},
                         {"own_y", Quantity::kAngle, 0, -0.5, 0.5, 0.005},
                         {"tip", Quantity::kAngle, 0, -0.5, 0.5, 0.005}},
          .places = places::ofRevoluteJoints,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::gravity_sag
