// What the joints can still do once a goal of higher rank holds: least-squares steps, each within what those before
// leave free. Internal to the inverse.
#pragma once

#include <Eigen/Core>

namespace tubeplan::deflection {

class FreeMotion {
 public:
  explicit FreeMotion(Eigen::Index joints) : projector_(Eigen::MatrixXd::Identity(joints, joints)) {}

  /// The shortest step that brings `slope` * step as near to `wanted` as what is free allows, and takes that from what
  /// is free. Directions that the free motion changes by less than `floor` per unit of it are left as they are.
  /// `Rows`: the most rows of the slopes, or Eigen::Dynamic.
  template <int Rows>
  Eigen::VectorXd take(const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Rows, Eigen::Dynamic>& slope,
                       const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Rows, 1>& wanted, double floor);

 private:
  Eigen::MatrixXd projector_;  ///< onto the motions that are free, joints x joints
};

}  // namespace tubeplan::deflection
