// The room that an arm without a described scene is known to have: that of the postures measured so far.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

/// The room of measured postures. A posture is safe if the arm hangs no lower than it did (the floor), and links that
/// are not neighbours come no nearer to one another than they did. Links are lines from frame to frame, so that the
/// room holds for links as thick as the measured ones.
class MeasuredRoom {
 public:
  /// `fitted` stands where the readings, one or more, were taken.
  MeasuredRoom(const calibration::PlacedArm& fitted, const std::vector<calibration::Measurement>& readings);

  /// Returns true if the arm has room at joint values `q` under a load [N], from the base of its last set-up.
  [[nodiscard]] bool holds(const Eigen::VectorXd& q, double load) const;

 private:
  calibration::PlacedArm fitted_;
  double lowest_ = std::numeric_limits<double>::infinity();  ///< height in the world [m]
  std::vector<double> nearest_;                              ///< least distance of each pair of links [m]
};

}  // namespace tubeplan::app
