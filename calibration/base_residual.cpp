#include "calibration/base_residual.hpp"

#include "calibration/touched_arm.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

Matrix3d encoderCovariance(const deflection::Arm& arm, const TipInWorld& tip) {
  Matrix3d covariance = Matrix3d::Zero();
  const auto active = deflection::activeRows(arm);
  for (int k = 0; k < static_cast<int>(active.size()); ++k) {
    const Vector3d column = tip.by_joints.col(k) * arm.rows[active[k]].joint.encoder_sigma;
    covariance += column * column.transpose();
  }
  return covariance;
}

}  // namespace

Eigen::Isometry3d moved(const Eigen::Isometry3d& X_WB, const BaseStep& step) {
  Eigen::Isometry3d result = X_WB;
  result.translation() += step.head<3>();
  result.linear() = deflection::rotationFromVector<double>(step.tail<3>()) * X_WB.linear();
  return result;
}

TipInWorld tipInWorld(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                      double load) {
  return TouchedArm(arm).tipInWorld(X_WB, q, load);
}

Matrix3d tipCovariance(const deflection::Arm& arm, const TipInWorld& tip,
                       const Eigen::Matrix<double, 6, 6>& base_covariance) {
  return tip.by_base * base_covariance * tip.by_base.transpose() + encoderCovariance(arm, tip);
}

Matrix3d touchCovariance(const deflection::Arm& arm, const TipInWorld& tip, double sigma) {
  return sigma * sigma * Matrix3d::Identity() + encoderCovariance(arm, tip);
}

}  // namespace tubeplan::calibration
