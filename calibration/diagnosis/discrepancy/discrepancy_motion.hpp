// Derivatives of a reading with respect to the errors of the joints' readings, the tool and the base, which are the
// channels of a discrepancy.
#pragma once

#include <vector>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Derivatives of a reading's rows [m] with respect to each channel at one posture: errors of the joints' readings
/// [rad, m], shifts along the tool's axes [m], shifts of the base [m], rotations of the base [rad].
struct Motion {
  Measurement at;                 ///< the reading itself, or its reference reading
  Eigen::MatrixXd displacements;  ///< rows of the reading x (joints + 9) channels
};

/// Returns the motions at every posture of a reading: its own posture and, for a displacement, the reference posture
/// with the opposite sign. Empty if the arm's shape does not converge.
[[nodiscard]] std::vector<Motion> motionsOf(ReadingPredictor& predictor, const PlacedArm& placed,
                                            const Measurement& reading);

}  // namespace tubeplan::calibration
