// Motion of a frame of the arm with the variables of a reading, and the measured values that follow from it. The
// derivation is the same for single postures and for postures solved side by side. Internal to the predictions.
#pragma once

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// The tool's frame or a row's frame, in the base frame. For a displacement, its motion from the reference posture.
struct FrameMotion {
  Eigen::Vector3d p_BF;  ///< position [m]
  Eigen::Matrix3d R_BF;  ///< only if the reading depends on it
  /// Slopes by variablesOf(): of position [m], then of rotation [rad], base axes.
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_BF;

  /// Subtracts the motion of the reference frame. If that posture has joint readings of its own, the last `own_joints`
  /// columns stay separate: this frame's first, then the reference's.
  void takeOff(const FrameMotion& from, Eigen::Index own_joints);
};

/// Returns the request's numbers and, where it asks for them, gravity's three rotations for the base, and the joints.
[[nodiscard]] std::vector<deflection::Variable> variablesOf(const PredictionRequest& request,
                                                            const deflection::Arm& arm);

/// Returns the number of joint columns of a displacement that are kept separate from the reference's.
[[nodiscard]] Eigen::Index ownJointsOf(const Measurement& reading, const PredictionRequest& request,
                                       const deflection::Arm& arm);

/// Fills in the requested slopes of a value that has the given slope by the frame's position and rotation in the world.
void deriveOf(const FrameMotion& frame, const MeasuredSlope& slope, const Eigen::Isometry3d& X_WB,
              const PredictionRequest& request, bool is_displacement, Prediction& prediction);

/// Fills in the measured values of a frame with that position and motion, where the arm stands at `X_WB`. Storage of
/// `prediction` is reused.
void predictOf(const FrameMotion& frame, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
               const Measurement& reading, const PredictionRequest& request, Prediction& prediction);

}  // namespace tubeplan::calibration
