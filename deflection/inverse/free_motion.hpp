// Motion that remains free for the joints once goals of higher priority are met: least-squares steps, each within the
// null space of the steps before. Internal to the inverse kinematics.
#pragma once

#include <Eigen/Core>

namespace tubeplan::deflection {

class FreeMotion {
 public:
  explicit FreeMotion(Eigen::Index joints) : projector_(Eigen::MatrixXd::Identity(joints, joints)) {}

  /// Returns the shortest free step that brings `slope` * step as close as possible to `wanted`, and removes the
  /// directions of such steps from the free motion. Directions in which a unit of free motion changes the goal by less
  /// than `floor` are ignored. `Rows` is the largest number of rows of `slope`, or Eigen::Dynamic.
  template <int Rows>
  Eigen::VectorXd take(const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Rows, Eigen::Dynamic>& slope,
                       const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Rows, 1>& wanted, double floor);

 private:
  Eigen::MatrixXd projector_;  ///< projector onto the free motions, joints x joints
};

}  // namespace tubeplan::deflection
