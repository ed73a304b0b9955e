// The room that an arm is known to have where nobody described it: what the postures measured so far took.
#pragma once

#include <limits>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::app {

/// A posture is safe where the arm hangs no lower than it did (the floor), and links that are not neighbours come no
/// nearer to one another than they did. Links are lines from frame to frame, so the room is that of links as thick as
/// the measured ones.
class MeasuredRoom {
 public:
  /// `fitted` stands where the readings, one or more, were taken.
  MeasuredRoom(const calibration::PlacedArm& fitted, const std::vector<calibration::Measurement>& readings);

  /// Whether the arm has room at joint values `q` under a load [N], from where its last set-up stands.
  [[nodiscard]] bool holds(const Eigen::VectorXd& q, double load) const;

 private:
  calibration::PlacedArm fitted_;
  double lowest_ = std::numeric_limits<double>::infinity();  ///< m, height in the world
  std::vector<double> nearest_;                              ///< m, of each pair of links
};

}  // namespace tubeplan::app
