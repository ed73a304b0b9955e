// Slopes of a reading by the channels of a discrepancy: joints, tool, base.
#pragma once

#include <vector>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Displacements of a reading's rows [m] per unit of each channel at one posture: the joints' readings [rad, m], shifts
/// along the tool's axes, shifts of the base, rotations of the base [rad].
struct Motion {
  Measurement at;                 ///< reading with this posture
  Eigen::MatrixXd displacements;  ///< rows x (joints + 9)
};

/// Returns the motions of every posture of a reading: its own and, for a displacement, the reference posture with the
/// opposite sign. Empty if the shape does not converge.
[[nodiscard]] std::vector<Motion> motionsOf(ReadingPredictor& predictor, const PlacedArm& placed,
                                            const Measurement& reading);

}  // namespace tubeplan::calibration
