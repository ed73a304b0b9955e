#include "deflection/inverse/rigid_branches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deflection/inverse/turret_branches.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;
constexpr double kLastReach = 1.1;  ///< of the elbow's cosine: goals beyond it are out of reach of any deflection

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

/// Both solutions of a cos x + b sin x = c; none where |c| is too large.
std::vector<double> solveCosineSine(double a, double b, double c) {
  const double r = std::hypot(a, b);
  if (r == 0 || std::abs(c) > r * (1 + 1e-12)) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / r, -1., 1.));
  if (half < 1e-9) return {middle};
  return {middle + half, middle - half};
}

/// The plane of the last three axes, as complex-like 2-D coordinates.
struct Plane {
  Vector3d origin, u, v;
  Vector2d operator()(const Vector3d& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  Vector2d direction(const Vector3d& d) const { return {u.dot(d), v.dot(d)}; }
};

double angleOf(const Vector2d& d) { return std::atan2(d.y(), d.x()); }
Vector2d turned(const Vector2d& d, double angle) { return Eigen::Rotation2Dd(angle) * d; }

/// Shoulder and elbow angles that bring the wrist to `w`, shoulder at the plane's origin, `elbow` and `wrist` at zero
/// readings.
std::vector<Vector2d> solveTwoLinks(const Vector2d& elbow, const Vector2d& wrist, const Vector2d& w) {
  const Vector2d upper = elbow, fore = wrist - elbow;
  const double l1 = upper.norm(), l2 = fore.norm();
  const double c = (w.squaredNorm() - l1 * l1 - l2 * l2) / (2 * l1 * l2);
  if (!(std::abs(c) <= kLastReach)) return {};
  // A bent arm may reach a little further than a rigid one: the elbow is started slightly bent there.
  const double at_zero = angleOf(fore) - angleOf(upper),
               bend = std::acos(std::abs(c) <= 1 ? c : std::copysign(0.98, c));
  std::vector<Vector2d> solutions;
  for (double sign : {1., -1.}) {
    const double elbow_angle = sign * bend - at_zero;
    const Vector2d reach = upper + turned(fore, elbow_angle);
    solutions.push_back({angleOf(w) - angleOf(reach), elbow_angle});
    if (bend < 1e-9) break;
  }
  return solutions;
}

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
  const Vector3d along = turret * turret.dot(h), across = h - along;
  const Vector3d p = goal.p_BT - axes.point[0];
  const double offset = h.dot(axes.tip - axes.point[0]);
  const double s3 = h.dot(axes.direction[2]) > 0 ? 1 : -1, s4 = h.dot(axes.direction[3]) > 0 ? 1 : -1;

  for (double q1 : solveCosineSine(across.dot(p), turret.cross(across).dot(p), offset - along.dot(p))) {
    const Matrix3d R = Eigen::AngleAxisd(q1, turret).toRotationMatrix();
    const Vector3d u = axes.tool_axis - h * h.dot(axes.tool_axis);
    if (u.norm() < 1e-9) continue;
    const Plane plane{axes.point[1], u.normalized(), h.cross(u).normalized()};
    const Vector3d tip_goal = axes.point[0] + R.transpose() * p;
    const Vector2d axis = plane.direction(R.transpose() * goal.axis_B);
    if (axis.norm() < 1e-9) continue;
    const double total = angleOf(axis);  // the tool's axis lies along u at zero readings
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
  // Kronecker lattice of the generalised golden ratio: even in any number of dimensions, the same on every machine.
  const int n = static_cast<int>(arm.jointCount());
  double ratio = 2;
  for (int k = 0; k < 60; ++k) ratio = std::pow(1 + ratio, 1. / (n + 1));
  for (int s = 0; s < count; ++s) {
    VectorXd q(n);
    for (int k = 0; k < n; ++k) {
      const auto& joint = arm.joint(k);
      const double span = joint.type == JointType::kPrismatic ? reachOf(arm) : kPi;
      const double lower = std::isfinite(joint.lower) ? joint.lower : -span,
                   upper = std::isfinite(joint.upper) ? joint.upper : span;
      const double share = std::fmod(0.5 + (s + 1) * std::pow(1 / ratio, k + 1), 1.);
      q[k] = lower + share * (upper - lower);
    }
    starts.push_back(q);
  }
  return starts;
}

}  // namespace tubeplan::deflection
