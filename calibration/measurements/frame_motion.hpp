// Motion of a frame of the arm with the variables of a reading, and the measured values that follow. Single postures
// and postures solved side by side (SIMD) share this derivation. Internal to the predictions.
#pragma once

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// The tool frame or a row's frame, in the base frame. For a displacement, its motion from the reference posture.
struct FrameMotion {
  Eigen::Vector3d p_BF;  ///< position of the frame's origin [m]
  Eigen::Matrix3d R_BF;  ///< rotation; valid only if the reading depends on it
  /// Derivatives with respect to variablesOf(): of position [m], then of rotation [rad], in base axes.
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_BF;

  /// Subtracts the motion of the reference frame. If the reference posture has joint readings of its own, the last
  /// `own_joints` columns stay separate: first those of this frame, then those of the reference.
  void takeOff(const FrameMotion& from, Eigen::Index own_joints);
};

/// Returns the variables of a request: its parameters, then, if requested, gravity's three rotations for the base, and
/// the joints.
[[nodiscard]] std::vector<deflection::Variable> variablesOf(const PredictionRequest& request,
                                                            const deflection::Arm& arm);

/// Returns the number of joint columns of a displacement that are kept separate from those of its reference.
[[nodiscard]] Eigen::Index ownJointsOf(const Measurement& reading, const PredictionRequest& request,
                                       const deflection::Arm& arm);

/// Fills in the requested derivatives of a value, given the value's derivatives with respect to the frame's pose in the
/// world.
void deriveOf(const FrameMotion& frame, const MeasuredSlope& slope, const Eigen::Isometry3d& X_WB,
              const PredictionRequest& request, bool is_displacement, Prediction& prediction);

/// Fills in the measured values of a frame with this position and motion, for a base at `X_WB`. The storage of
/// `prediction` is reused.
void predictOf(const FrameMotion& frame, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
               const Measurement& reading, const PredictionRequest& request, Prediction& prediction);

}  // namespace tubeplan::calibration
