// Room known to be free for an arm without a described scene, derived from the postures measured so far.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

/// Region that the measured postures show to be free. A posture is inside if the arm hangs no lower than in the
/// measured postures (the floor), and if no two links that are not neighbours come closer to each other than in the
/// measured postures. Links are lines between frames. Their thickness needs no allowance, because the links were
/// equally close in a measured posture.
class MeasuredRoom {
 public:
  /// There must be at least one measurement, and `fitted` must have a base pose for each set-up of the measurements.
  MeasuredRoom(const calibration::PlacedArm& fitted, const std::vector<calibration::Measurement>& measurements);

  /// Returns true if the posture `q` [rad, m] under a load [N] is inside the room, with the arm on the base of its last
  /// set-up.
  [[nodiscard]] bool contains(const Eigen::VectorXd& q, double load) const;

 private:
  calibration::PlacedArm fitted_;
  /// Height of the lowest frame over all measured postures, in the world [m].
  double lowest_ = std::numeric_limits<double>::infinity();
  std::vector<double> nearest_;  ///< smallest distance of each pair of links in the measured postures [m]
};

}  // namespace tubeplan::app
