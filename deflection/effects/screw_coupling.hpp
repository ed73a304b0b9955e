// A prismatic joint that a revolute joint also moves along their common screw, as on the ball screw spline of a SCARA's
// last axes.
//
// Law: true value of the prismatic joint = its reading + travel * reading of the revolute joint, as in
//      joint_coupling.hpp.
// Symbols: travel [m/rad]: lead of the screw per rotation angle, if the controller does not compensate for it.
// Validity: readings counted from the encoders' zeros.
// Source: coupled joints in Craig, Introduction to Robotics (actuator space and joint space).
#pragma once

#include "deflection/effects/joint_coupling.hpp"

namespace tubeplan::deflection::screw_coupling {

inline EffectKind kind() {
  return {.name = "screw-coupling",
          .words = "a joint's turning moves a slide along its screw",
          .law = "true position of the slide = reading + travel * reading of a revolute joint, in radians",
          .validity = "a slide and a revolute joint",
          .source = "Craig, Introduction to Robotics: actuator and joint space",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJointPair,
          .odds = 0.5,
          .odds_reason = "only where both are on one screw, and the controller does not compensate for its lead",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"travel", Quantity::kLength, 0, -0.1, 0.1, 2e-3}},
          .places = places::ofSlidesTurned,
          .apply = joint_coupling::apply<double>,
          .applyDual = joint_coupling::apply<Dual>};
}

}  // namespace tubeplan::deflection::screw_coupling
