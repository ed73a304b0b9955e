// How a reading moves with what a discrepancy may have err: joints, tool, base.
#pragma once

#include <vector>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// How a reading's rows move [m] with each channel at a posture that it is made of: a joint's reading [rad, m], a shift
/// along the tool's axes, of the base, a turn of the base [rad].
struct Motion {
  Measurement at;                 ///< states the posture
  Eigen::MatrixXd displacements;  ///< rows x (joints + 9)
};

/// Of every posture that the reading is made of: its own and, of a displacement, the one that it is taken from, with
/// the other sign. Empty where the shape does not converge.
[[nodiscard]] std::vector<Motion> motionsOf(ReadingPredictor& predictor, const PlacedArm& placed,
                                            const Measurement& reading);

}  // namespace tubeplan::calibration
