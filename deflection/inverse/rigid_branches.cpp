#include "deflection/inverse/rigid_branches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deflection/inverse/subproblems.hpp"
#include "deflection/inverse/turret_branches.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

}  // namespace

bool carriesPlane(const AxesAtZero& axes) {
  if (axes.point.size() != 4 || std::ranges::count(axes.slides, true) != 0) return false;
  const double parallel = std::cos(5 * kPi / 180);
  const Vector3d& h = axes.direction[1];
  return std::abs(h.dot(axes.direction[2])) > parallel && std::abs(h.dot(axes.direction[3])) > parallel &&
         std::abs(h.dot(axes.direction[0])) < std::cos(kPi / 6);
}

void addTurretBranches(const AxesAtZero& axes, const ToolGoal& goal, std::vector<VectorXd>& branches) {
  const Vector3d& turret = axes.direction[0];
  const Vector3d& h = axes.direction[1];
  const Vector3d p = goal.p_BT - axes.point[0];
  const double s3 = h.dot(axes.direction[2]) > 0 ? 1 : -1, s4 = h.dot(axes.direction[3]) > 0 ? 1 : -1;

  for (double q1 : solveOffset(turret, h, p, h.dot(axes.tip - axes.point[0]))) {
    const Matrix3d R = Eigen::AngleAxisd(q1, turret).toRotationMatrix();
    const Vector3d u = axes.tool_axis - h * h.dot(axes.tool_axis);
    if (u.norm() < 1e-9) continue;
    const Plane plane{axes.point[1], u.normalized(), h.cross(u).normalized()};
    const Vector3d tip_goal = axes.point[0] + R.transpose() * p;
    const Vector2d axis = plane.direction(R.transpose() * goal.axis_B);
    if (axis.norm() < 1e-9) continue;
    const double total = angleOf(axis);  // at zero readings, the tool axis points along u
    const Vector2d hand = plane(axes.tip) - plane(axes.point[3]);
    const Vector2d wrist_goal = plane(tip_goal) - turned(hand, total);
    for (const Vector2d& s : solveTwoLinks(plane(axes.point[2]), plane(axes.point[3]), wrist_goal)) {
      VectorXd q(4);
      q << wrapped(q1), wrapped(s[0]), wrapped(s3 * s[1]), wrapped(s4 * (total - s[0] - s[1]));
      branches.push_back(q);
    }
  }
}

bool isTurretArm(const Arm& arm) { return carriesPlane(axesAtZero(arm)); }

std::vector<VectorXd> turretBranches(const Arm& arm, const ToolGoal& goal) {
  std::vector<VectorXd> branches;
  addTurretBranches(axesAtZero(arm), goal, branches);
  return branches;
}

std::vector<VectorXd> latticeStarts(const Arm& arm, int count) {
  std::vector<VectorXd> starts;
  // Kronecker lattice of the generalised golden ratio: evenly distributed in any number of dimensions, and the same on
  // every machine.
  const int n = static_cast<int>(arm.jointCount());
  double ratio = 2;
  for (int k = 0; k < 60; ++k) ratio = std::pow(1 + ratio, 1. / (n + 1));
  for (int s = 0; s < count; ++s) {
    VectorXd q(n);
    for (int k = 0; k < n; ++k) {
      const auto [lower, upper] = rangeOf(arm, arm.joint(k));
      const double share = std::fmod(0.5 + (s + 1) * std::pow(1 / ratio, k + 1), 1.);
      q[k] = lower + share * (upper - lower);
    }
    starts.push_back(q);
  }
  return starts;
}

}  // namespace tubeplan::deflection
