// How a frame of the arm moves with what a reading depends on, and what is then measured of it: one derivation, whether
// a frame's motion comes posture by posture or side by side. Internal to the predictions.
#pragma once

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// The tool's frame, or a row's, as seen from the base; of a displacement its way from where that is taken.
struct FrameMotion {
  Eigen::Vector3d p_BF;                            ///< m
  Eigen::Matrix3d R_BF;                            ///< only where the reading sees its turn
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_BF;  ///< by variablesOf(): its place [m], then its turn [rad], base axes

  /// Leaves the way from another frame. Where that one's joints are other readings than this one's, the last
  /// `own_joints` columns stand apart: this frame's first, then what it is taken from.
  void takeOff(const FrameMotion& from, Eigen::Index own_joints);
};

/// The request's numbers; then, where it asks for them, gravity's three turns for the base, and the joints.
[[nodiscard]] std::vector<deflection::Variable> variablesOf(const PredictionRequest& request,
                                                            const deflection::Arm& arm);

/// How many columns of a displacement's joints stand apart.
[[nodiscard]] Eigen::Index ownJointsOf(const Measurement& reading, const PredictionRequest& request,
                                       const deflection::Arm& arm);

/// Fills in the slopes that are asked for of what changes so with the frame's place and turn in the world.
void deriveOf(const FrameMotion& frame, const MeasuredSlope& slope, const Eigen::Isometry3d& X_WB,
              const PredictionRequest& request, bool is_displacement, Prediction& prediction);

/// Fills in what is measured of a frame that stands and moves so, where the arm stands at `X_WB`; storage is used
/// again.
void predictOf(const FrameMotion& frame, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
               const Measurement& reading, const PredictionRequest& request, Prediction& prediction);

}  // namespace tubeplan::calibration
