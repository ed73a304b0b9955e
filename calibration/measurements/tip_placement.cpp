#include "calibration/measurements/tip_placement.hpp"

#include "deflection/chain.hpp"

namespace tubeplan::calibration {

namespace {

using deflection::Arm, deflection::FlexibleKinematics, deflection::KinematicsStatus, deflection::Posture;
using Eigen::Matrix3Xd, Eigen::Vector3d, Eigen::VectorXd;

constexpr deflection::FlexibleKinematicsOptions kExact{1e-13, 100};
constexpr double kLongestStep = 0.5;  // longest step [rad or m]

/// Returns the Jacobian of the tip's position with respect to the joints, as if the deflected shape were rigid.
Matrix3Xd stiffJacobian(const Arm& arm, const FlexibleKinematics& shape) {
  const auto active = deflection::activeRows(arm);
  Matrix3Xd columns(3, static_cast<Eigen::Index>(active.size()));
  for (int k = 0; k < columns.cols(); ++k) {
    const auto& X_BL = shape.rows[active[k]].X_BL;
    const Vector3d axis = X_BL.R.col(2);
    const bool slides = arm.rows[active[k]].joint.type == deflection::JointType::kPrismatic;
    columns.col(k) = slides ? axis : Vector3d(axis.cross(shape.X_BD.p - X_BL.p));
  }
  for (std::size_t row = 0; row < arm.rows.size(); ++row)
    for (const auto& followed : arm.rows[row].joint.follows) {
      const auto& X_BL = shape.rows[row].X_BL;
      const Vector3d axis = X_BL.R.col(2);
      columns.col(deflection::jointIndexOf(arm, followed.row)) += followed.ratio * axis.cross(shape.X_BD.p - X_BL.p);
    }
  return columns;
}

VectorXd stepTowards(const Matrix3Xd& jacobian, const Vector3d& off) {
  const VectorXd step = jacobian.completeOrthogonalDecomposition().solve(off);
  const double longest = step.cwiseAbs().maxCoeff();
  return longest > kLongestStep ? VectorXd(step * (kLongestStep / longest)) : step;
}

bool isStretched(const Matrix3Xd& jacobian, double reach, double floor) {
  const Eigen::Matrix3d square = jacobian * jacobian.transpose() / (reach * reach);
  return square.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() < floor * floor;
}

/// Search for a posture that places the tip at the goal; holds the posture reached so far and the Jacobian for the next
/// step.
class TipSearch {
 public:
  TipSearch(const Arm& arm, Posture start, const Vector3d& goal_B)
      : arm_(arm), goal_B_(goal_B), posture_(std::move(start)) {
    shape_ = deflection::solveFlexibleKinematics(arm_, posture_, kExact);
    refresh();
  }

  [[nodiscard]] const VectorXd& q() const { return posture_.q; }
  [[nodiscard]] double distance() const { return (goal_B_ - shape_.X_BD.p).norm(); }
  [[nodiscard]] bool isConverged() const { return shape_.status == KinematicsStatus::kConverged; }
  [[nodiscard]] Matrix3Xd jacobian() const { return stiffJacobian(arm_, shape_); }

  /// Takes a step, which is halved until it brings the tip nearer to the goal; returns false if even the shortest one
  /// does not.
  bool advance() {
    VectorXd step = stepTowards(jacobian_, goal_B_ - shape_.X_BD.p);
    for (int halvings = 0; halvings < 12; ++halvings, step /= 2) {
      Posture next = posture_;
      next.q += step;
      FlexibleKinematics shape = deflection::solveFlexibleKinematics(arm_, next, kExact);
      if (shape.status != KinematicsStatus::kConverged || !((goal_B_ - shape.X_BD.p).norm() < distance())) continue;
      const Vector3d moved = shape.X_BD.p - shape_.X_BD.p;
      posture_ = std::move(next);
      shape_ = std::move(shape);
      if (step.norm() > kFarStep)
        refresh();
      else
        jacobian_ += (moved - jacobian_ * step) * step.transpose() / step.squaredNorm();
      return true;
    }
    return false;
  }

 private:
  static constexpr double kFarStep = 0.05;  // after a longer step, the Jacobian is recomputed [rad or m]

  void refresh() {
    if (isConverged()) jacobian_ = jacobian();
  }

  const Arm& arm_;
  Vector3d goal_B_;
  Posture posture_;
  FlexibleKinematics shape_;
  Matrix3Xd jacobian_;
};

}  // namespace

TipPlacement placeTip(const Arm& arm, const Posture& start, const Vector3d& p_BT, const TipPlacementOptions& options) {
  TipPlacement placement{TipPlacementStatus::kNotConverged, start.q};
  TipSearch search(arm, start, p_BT);
  if (!search.isConverged()) return placement;
  for (int k = 0; k < options.max_iterations && search.distance() >= options.tolerance; ++k)
    if (!search.advance()) break;
  placement.q = search.q();
  if (search.distance() >= options.tolerance) return placement;
  const bool is_stretched = isStretched(search.jacobian(), deflection::reachOf(arm), options.singular_floor);
  placement.status = is_stretched ? TipPlacementStatus::kStretched : TipPlacementStatus::kPlaced;
  return placement;
}

}  // namespace tubeplan::calibration
