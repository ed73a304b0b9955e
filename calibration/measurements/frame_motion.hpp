// Pose of a frame of the arm with its derivatives, and the measured values computed from it. These functions are shared
// by single postures and by postures solved side by side (SIMD). Internal to the predictions.
#pragma once

#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

/// Pose of the tool frame or of a row's frame in the base frame, with its derivatives. For a displacement, the
/// difference from the reference posture.
struct FrameMotion {
  Eigen::Vector3d p_BF;  ///< position of the frame's origin [m]
  Eigen::Matrix3d R_BF;  ///< rotation; valid only if the measurement depends on it
  /// Derivatives with respect to variablesOf(): of position [m], then of rotation [rad], in base axes.
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_BF;

  /// Subtracts position and derivatives of the reference frame. If the reference posture has joint readings of its own,
  /// the last `own_joints` columns stay separate: first those of this frame, then those of the reference.
  void subtract(const FrameMotion& from, Eigen::Index own_joints);
};

/// Returns the variables of the derivatives that a request needs: its parameters; three rotations of gravity if
/// derivatives with respect to the base are requested; the joints if requested.
[[nodiscard]] std::vector<deflection::Variable> variablesOf(const PredictionRequest& request,
                                                            const deflection::Arm& arm);

/// Returns the number of joint columns that a displacement keeps in addition to the columns of its reference; 0 if the
/// two share their joint readings.
[[nodiscard]] Eigen::Index ownJointsOf(const Measurement& measurement, const PredictionRequest& request,
                                       const deflection::Arm& arm);

/// Fills in the derivatives of a measured value that `request` asks for, from `slope`, the derivatives of the value
/// with respect to the frame's pose in the world.
void deriveOf(const FrameMotion& frame, const MeasuredSlope& slope, const Eigen::Isometry3d& X_WB,
              const PredictionRequest& request, bool is_displacement, Prediction& prediction);

/// Fills in the values that a measurement measures of this frame, and the requested derivatives, for a base at `X_WB`.
/// The storage of `prediction` is reused.
void predictOf(const FrameMotion& frame, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
               const Measurement& measurement, const PredictionRequest& request, Prediction& prediction);

}  // namespace tubeplan::calibration
