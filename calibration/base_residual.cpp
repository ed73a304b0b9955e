#include "calibration/base_residual.hpp"

#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

Matrix3d crossMatrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

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
  auto variables = deflection::jointVariables(arm);
  const int joints = static_cast<int>(variables.size());
  for (int axis = 0; axis < 3; ++axis) variables.push_back(deflection::Variable::gravityTurn(axis));
  const auto derivatives =
      deflection::differentiateTip(arm, {q, load, deflection::gravityInBase(arm, X_WB)}, variables, {1e-12, 100});
  TipInWorld tip;
  tip.ok = derivatives.kinematics.status == deflection::KinematicsStatus::kConverged;
  const Matrix3d R = X_WB.linear();
  const Vector3d r_W = R * derivatives.kinematics.X_BD.p;
  tip.p_WT = X_WB.translation() + r_W;
  tip.by_base.leftCols<3>().setIdentity();
  // Turning the base by w turns the arm by w, and gravity, seen from the base, by -w.
  tip.by_base.rightCols<3>() = -crossMatrix(r_W) - R * derivatives.position_B.rightCols<3>() * R.transpose();
  tip.by_joints = R * derivatives.position_B.leftCols(joints);
  return tip;
}

Matrix3d tipCovariance(const deflection::Arm& arm, const TipInWorld& tip,
                       const Eigen::Matrix<double, 6, 6>& base_covariance) {
  return tip.by_base * base_covariance * tip.by_base.transpose() + encoderCovariance(arm, tip);
}

Matrix3d touchCovariance(const deflection::Arm& arm, const TipInWorld& tip, double sigma) {
  return sigma * sigma * Matrix3d::Identity() + encoderCovariance(arm, tip);
}

}  // namespace tubeplan::calibration
