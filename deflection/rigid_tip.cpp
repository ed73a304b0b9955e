#include "deflection/rigid_tip.hpp"

#include "deflection/flexible_kinematics.hpp"
#include "deflection/resized.hpp"
#include "deflection/shortest_chain.hpp"

namespace tubeplan::deflection {

using Eigen::Matrix3d, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// Moves the points that locate the revolute axes close together if they are far apart, because cancellation of long
/// vectors loses digits. Prismatic joints need no point.
void drawAxesTogether(AxesAtZero& axes) {
  std::vector<ChainLine> chain{{Vector3d::Zero(), Vector3d::UnitZ(), false}};
  for (std::size_t k = 0; k < axes.point.size(); ++k)
    if (!axes.slides[k]) chain.push_back({axes.point[k], axes.direction[k]});
  chain.push_back({axes.tip, Vector3d::UnitZ(), false});
  drawTogether(chain);
  std::size_t turning = 0;
  for (std::size_t k = 0; k < axes.point.size(); ++k)
    if (!axes.slides[k]) axes.point[k] = chain[++turning].point;
}

}  // namespace

AxesAtZero axesAtZero(const Arm& arm) {
  const auto active = activeRows(arm);
  const auto zero = solveFlexibleKinematics(rigidCopy(arm), {VectorXd::Zero(static_cast<Eigen::Index>(active.size()))});
  AxesAtZero axes;
  for (const int row : active) {
    const auto& frame = zero.rows[static_cast<std::size_t>(row)].X_BL_rigid;
    axes.point.push_back(frame.p);
    axes.direction.push_back(frame.R.col(2));
    axes.slides.push_back(arm.rows[static_cast<std::size_t>(row)].joint.type == JointType::kPrismatic);
  }
  axes.tip = zero.X_BT.p;
  axes.tool_axis = zero.X_BT.R * arm.tool_axis_L;
  drawAxesTogether(axes);
  return axes;
}

void placeRigidTip(const AxesAtZero& axes, const Eigen::Ref<const VectorXd>& q, TipMotion& tip) {
  const auto n = static_cast<Eigen::Index>(axes.point.size());
  resizeOrEmpty(tip.columns, 6, n);
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();
  // First store each joint's direction and a point on its axis. The point temporarily occupies the upper half of the
  // joint's column.
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto j = static_cast<std::size_t>(k);
    tip.columns.col(k) << R * axes.point[j] + p, R * axes.direction[j];
    if (axes.slides[j]) {
      p += R * axes.direction[j] * q[k];
      continue;
    }
    const Matrix3d turn = Eigen::AngleAxisd(q[k], axes.direction[j]).toRotationMatrix();
    p += R * (axes.point[j] - turn * axes.point[j]);
    R = R * turn;
  }
  tip.p = R * axes.tip + p;
  tip.axis = R * axes.tool_axis;
  tip.last_axis = tip.columns.col(n - 1).tail<3>();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector3d point = tip.columns.col(k).head<3>(), direction = tip.columns.col(k).tail<3>();
    if (axes.slides[static_cast<std::size_t>(k)])
      tip.columns.col(k) << direction, Vector3d::Zero();
    else
      tip.columns.col(k).head<3>() = direction.cross(tip.p - point);
  }
}

}  // namespace tubeplan::deflection
