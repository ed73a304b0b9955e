// Derivatives of a measurement with respect to the errors of the joints' readings, the tool and the base, which are
// the channels of a discrepancy.
#pragma once

#include <vector>

#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

/// Derivatives of a measurement's rows [m] with respect to each channel at one posture: errors of the joint readings
/// [rad, m], shifts along the tool's axes [m], shifts of the base [m], rotations of the base [rad].
struct Motion {
  Measurement at;                 ///< the measurement itself, or its reference measurement
  Eigen::MatrixXd displacements;  ///< rows of the measurement x (joints + 9) channels
};

/// Returns the motions at every posture of a measurement: its own posture and, for a displacement, the reference
/// posture with the opposite sign. Empty if the arm's shape does not converge.
[[nodiscard]] std::vector<Motion> motionsOf(MeasurementPredictor& predictor, const PlacedArm& placed,
                                            const Measurement& measurement);

}  // namespace tubeplan::calibration
