// Arms whose effects only shift the joints: the bare arm at the true joint values, and derivatives by the chain rule.
// Internal to predictAll().
#pragma once

#include "calibration/measurements/frame_motion.hpp"
#include "deflection/effects/joint_shift.hpp"

namespace tubeplan::calibration {

class ShiftedJoints {
 public:
  /// Prepares the derivatives of `request`, none of them with respect to the readings, for an arm all of whose effects
  /// only shift joints.
  ShiftedJoints(const deflection::Arm& arm, const PredictionRequest& request);

  [[nodiscard]] const deflection::Arm& bareArm() const { return bare_; }

  /// Returns the variables of the bare arm from which compose() forms the requested derivatives.
  [[nodiscard]] const std::vector<deflection::Variable>& variables() const { return variables_; }

  /// Returns the true joint values at the readings of `posture`.
  [[nodiscard]] Eigen::VectorXd valuesAt(const deflection::Posture& posture) const;

  /// Forms the requested derivatives at the readings of `posture` from those with respect to variables().
  void compose(const deflection::Posture& posture, const Eigen::Matrix<double, 6, Eigen::Dynamic>& by_variables,
               Eigen::Matrix<double, 6, Eigen::Dynamic>& by_requested) const;

 private:
  /// A requested derivative with respect to a parameter of an effect.
  struct OfEffect {
    Eigen::Index column;
    deflection::Effect unit;  ///< the effect with this parameter equal to 1 and the others 0
  };

  const deflection::Arm& arm_;
  deflection::Arm bare_;
  std::vector<deflection::Variable> variables_;  // those requested of the bare arm, followed by the joints
  std::vector<Eigen::Index> columns_;            // requested column of each variable of the bare arm
  std::vector<OfEffect> of_effects_;
};

}  // namespace tubeplan::calibration
