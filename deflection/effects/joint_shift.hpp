// Shift of the joints by one effect on joint readings, without solving the arm's shape.
#pragma once

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

/// Returns true if the effect adds to the true joint values, linearly in its parameters, and does nothing else.
[[nodiscard]] inline bool shiftsJoints(const Effect& effect) {
  return !effect.formula && kindOf(effect).stage == EffectStage::kJointReading;
}

/// Joints of an arm at one posture, which effects shift. `arm` and `posture` must outlive the object.
class JointShift {
 public:
  JointShift(const Arm& arm, const Posture& posture) : context_(arm, posture) {}

  /// Returns the true joint values that `effect` alone adds to the readings [rad or m]. The result is valid until the
  /// next call.
  [[nodiscard]] const Eigen::VectorXd& by(const Effect& effect) {
    context_.posture.q.setZero(context_.nominal_posture.q.size());
    kindOf(effect).apply(effect, context_);
    return context_.posture.q;
  }

 private:
  EffectContext<double> context_;
};

}  // namespace tubeplan::deflection
