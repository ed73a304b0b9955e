#include "calibration/touched_arm.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

Matrix3d crossMatrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

TouchedArm::TouchedArm(const deflection::Arm& arm)
    : arm_(arm), variables_(deflection::jointVariables(arm)), tips_(arm), shapes_(arm) {
  for (int axis = 0; axis < 3; ++axis) variables_.push_back(deflection::Variable::gravityTurn(axis));
}

TipInWorld TouchedArm::tipInWorld(const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q, double load) {
  const auto status = tips_.solve({q, load, deflection::gravityInBase(arm_, X_WB)}, variables_, {1e-12, 100});
  const Eigen::Matrix3Xd columns = tips_.columns().topRows<3>();
  TipInWorld tip;
  tip.ok = status == deflection::KinematicsStatus::kConverged;
  const Matrix3d R = X_WB.linear();
  const Vector3d r_W = R * tips_.arm().X_BD().p;
  tip.p_WT = X_WB.translation() + r_W;
  tip.by_base.leftCols<3>().setIdentity();
  // Turning the base by w turns the arm by w, and gravity, seen from the base, by -w.
  tip.by_base.rightCols<3>() = -crossMatrix(r_W) - R * columns.rightCols<3>() * R.transpose();
  tip.by_joints = R * columns.leftCols(columns.cols() - 3);
  return tip;
}

Vector3d TouchedArm::tipInBase(const Eigen::Isometry3d& X_WB, const Touch& touch,
                               const deflection::FlexibleKinematicsOptions& options, bool must_settle) {
  const auto status = shapes_.solve({touch.q, touch.load, deflection::gravityInBase(arm_, X_WB)}, options);
  if (must_settle && status != deflection::KinematicsStatus::kConverged)
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return shapes_.X_BD().p;
}

}  // namespace tubeplan::calibration
