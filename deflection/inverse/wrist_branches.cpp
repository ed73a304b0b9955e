#include "deflection/inverse/wrist_branches.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "deflection/inverse/subproblems.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::Matrix3d, Eigen::Vector3d, Eigen::VectorXd;
/// Tolerance within which axes are treated as intersecting or parallel [fraction of the reach, rad].
constexpr double kMeet = 1e-3;
constexpr double kParallel = 0.02;     ///< largest angle between axes treated as parallel; iterations correct it [rad]
constexpr double kLeastSine = 0.2;     ///< smallest sine of the angle between successive axes of a wrist
constexpr double kStretched = 1e-6;    ///< excess of a cosine over 1 that is attributed to rounding
constexpr double kInLine = 1e-6;       ///< angle below which two axes are collinear [rad]
constexpr double kNearlyInLine = 0.1;  ///< angle below which axes may become collinear on a flexible arm [rad]
constexpr double kSameRoot = 0.5;      ///< largest change of a root's readings from one roll to the next [rad, m]
constexpr int kTurnsInLine = 6;        ///< number of samples of the redundant rotation of two collinear joints
constexpr double kNear = 0.01;         ///< largest position error of a usable wrist centre, as a fraction of the reach
/// Largest position error of a converged wrist centre, as a fraction of the reach.
constexpr double kAtItsPlace = 1e-7;
constexpr double kLongestStep = 0.5;  ///< longest step of a joint [rad or fraction of the reach]
constexpr int kMostSteps = 6;

/// Returns the point with the smallest sum of squared distances from the last three axes.
Vector3d wristCentre(const AxesAtZero& axes) {
  Matrix3d sum = Matrix3d::Zero();
  Vector3d side = Vector3d::Zero();
  for (std::size_t k = axes.point.size() - 3; k < axes.point.size(); ++k) {
    const Matrix3d across = Matrix3d::Identity() - axes.direction[k] * axes.direction[k].transpose();
    sum += across;
    side += across * axes.point[k];
  }
  return sum.ldlt().solve(side);
}

double distanceFromAxis(const AxesAtZero& axes, std::size_t k, const Vector3d& p) {
  return axes.direction[k].cross(p - axes.point[k]).norm();
}

/// Returns a right-handed frame whose third direction is the axis, rotated about the axis by `roll` [rad].
Matrix3d frameAbout(const Vector3d& axis, double roll) {
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  Matrix3d R;
  R << std::cos(roll) * u + std::sin(roll) * v, std::cos(roll) * v - std::sin(roll) * u, axis;
  return R;
}

/// Returns true if the first of three joints is a turret that carries two links in a plane.
bool carriesTwoLinks(const AxesAtZero& three) {
  return std::ranges::count(three.slides, true) == 0 &&
         three.direction[1].cross(three.direction[2]).norm() < kParallel &&
         three.direction[0].cross(three.direction[1]).norm() > kLeastSine;
}

Matrix3d turnOf(const AxesAtZero& axes, const VectorXd& q) {
  Matrix3d R = Matrix3d::Identity();
  for (std::size_t k = 0; k < axes.point.size(); ++k)
    if (!axes.slides[k]) R = R * Eigen::AngleAxisd(q[static_cast<Index>(k)], axes.direction[k]).toRotationMatrix();
  return R;
}

}  // namespace

bool carriesWrist(const AxesAtZero& axes, double reach) {
  const std::size_t n = axes.point.size();
  if (n < 6 || std::any_of(axes.slides.end() - 3, axes.slides.end(), [](bool slides) { return slides; })) return false;
  for (const std::size_t k : {n - 3, n - 2})
    if (axes.direction[k].cross(axes.direction[k + 1]).norm() < kLeastSine) return false;
  const Vector3d centre = wristCentre(axes);
  for (const std::size_t k : {n - 3, n - 2, n - 1})
    if (distanceFromAxis(axes, k, centre) > kMeet * reach) return false;
  return true;
}

AxesAtZero axesBeforeWrist(const AxesAtZero& axes) {
  AxesAtZero before = axes;
  before.tip = wristCentre(axes);
  const std::size_t count = axes.point.size() - 3;
  before.point.resize(count);
  before.direction.resize(count);
  before.slides.resize(count);
  return before;
}

WristBranches::WristBranches(const AxesAtZero& axes, double reach)
    : axes_(axes),
      arm_(axesBeforeWrist(axes)),
      loop_(closureChain<kPlaceSize>(arm_, reach)),
      reach_(reach),
      carries_two_links_(carriesTwoLinks(arm_)),
      last_turns_in_place_(distanceFromAxis(axes, 5, axes.tip) < kMeet * reach &&
                           axes.direction[5].cross(axes.tool_axis).norm() < kMeet) {
  assert(axes.point.size() == 6);
}

bool WristBranches::iterate(const Vector3d& p_BW, VectorXd& arm) const {
  TipMotion tip;
  Vector3d off;
  for (int step = 0; step <= kMostSteps; ++step) {
    placeRigidTip(arm_, arm, tip);
    off = p_BW - tip.p;
    if (off.norm() < kAtItsPlace * reach_) break;
    Matrix3d slopes = tip.columns.topRows<3>();
    for (Index k = 0; k < 3; ++k)
      if (arm_.slides[static_cast<std::size_t>(k)]) slopes.col(k) *= reach_;
    Vector3d by = slopes.partialPivLu().solve(off);
    // Near the edge of the reach, the wrist centre may only come near its position. Steps then become too long, and the
    // iteration ends.
    if (!(by.cwiseAbs().maxCoeff() < kLongestStep)) break;
    for (Index k = 0; k < 3; ++k) arm[k] += arm_.slides[static_cast<std::size_t>(k)] ? by[k] * reach_ : by[k];
  }
  return off.norm() < kNear * reach_;
}

Matrix3d WristBranches::turnAt(const ToolGoal& goal, double roll) const {
  return frameAbout(goal.axis_B, last_turns_in_place_ ? 0 : roll) * frameAbout(axes_.tool_axis, 0).transpose();
}

WristBranches::Root WristBranches::rootAt(VectorXd arm, const Matrix3d& R) const {
  const Matrix3d turn = turnOf(arm_, arm).transpose() * R;
  const Vector3d to = turn * axes_.direction[5], u = axes_.direction[3].unitOrthogonal();
  return {std::move(arm), turn, {u.dot(to), axes_.direction[3].cross(u).dot(to)}};
}

/// Returns readings of the first three joints that bring the wrist centre near its position.
std::vector<VectorXd> WristBranches::armsAt(const Vector3d& p_BW, double most_imaginary) const {
  std::vector<VectorXd> arms;
  if (!carries_two_links_) {
    loop_.addRoots(p_BW, Vector3d::UnitZ(), most_imaginary, arms);
    return arms;
  }
  const Vector3d &turret = arm_.direction[0], &h = arm_.direction[1], &shoulder = arm_.point[1];
  const Vector3d p = p_BW - arm_.point[0], u = h.unitOrthogonal();
  const double sense = h.dot(arm_.direction[2]) > 0 ? 1 : -1;
  const Plane plane{shoulder, u, h.cross(u)};
  for (const double q1 : solveOffset(turret, h, p, h.dot(arm_.tip - arm_.point[0]))) {
    const Vector3d w = arm_.point[0] + Eigen::AngleAxisd(-q1, turret) * p;
    for (const Eigen::Vector2d& s : solveTwoLinks(plane(arm_.point[2]), plane(arm_.tip), plane(w)))
      arms.push_back(Vector3d(q1, s[0], sense * s[1]));
  }
  return arms;
}

std::vector<WristBranches::Root> WristBranches::rootsAt(const ToolGoal& goal, double roll,
                                                        double most_imaginary) const {
  const Matrix3d R = turnAt(goal, roll);
  const Vector3d p_BW = goal.p_BT + R * (arm_.tip - axes_.tip);
  std::vector<Root> roots;
  for (VectorXd& arm : armsAt(p_BW, most_imaginary))
    if (iterate(p_BW, arm)) roots.push_back(rootAt(std::move(arm), R));
  return roots;
}

VectorXd WristBranches::withWrist(const Root& root, double q4, double q5) const {
  const Vector3d &w4 = axes_.direction[3], &w5 = axes_.direction[4], &w6 = axes_.direction[5],
                 side = w6.unitOrthogonal();
  const Vector3d turned = Eigen::AngleAxisd(-q5, w5) * (Eigen::AngleAxisd(-q4, w4) * (root.turn * side));
  VectorXd q(6);
  q << root.arm, q4, q5, turnBetween(w6, side, turned);
  return q;
}

void WristBranches::addWrists(const Root& root, double q4_in_line, std::vector<VectorXd>& postures) const {
  const Vector3d &w4 = axes_.direction[3], &w5 = axes_.direction[4], &w6 = axes_.direction[5];
  const Vector3d to = root.turn * w6;
  const double along = w4.dot(w5) * w5.dot(w6);
  for (const double q5 : solveCosineSine(w4.dot(w6) - along, w4.dot(w5.cross(w6)), w4.dot(to) - along, kStretched)) {
    const Vector3d bent = Eigen::AngleAxisd(q5, w5) * w6;
    postures.push_back(withWrist(root, bent.cross(w4).norm() < kInLine ? q4_in_line : turnBetween(w4, bent, to), q5));
  }
}

void WristBranches::addInLineBetween(const ToolGoal& goal, std::span<const Root> from, double from_roll,
                                     std::span<const Root> to, double to_roll, std::vector<VectorXd>& postures) const {
  const Vector3d &w4 = axes_.direction[3], &w5 = axes_.direction[4], &w6 = axes_.direction[5];
  const double ahead = turnBetween(w5, w6, w4);  // reading at which the last axis points along the third-to-last
  for (const Root& a : from)
    for (const Root& b : to) {
      VectorXd way = b.arm - a.arm;
      for (Index k = 0; k < 3; ++k)
        if (!arm_.slides[static_cast<std::size_t>(k)]) way[k] = std::remainder(way[k], kFullTurn);
      if (way.cwiseAbs().maxCoeff() > kSameRoot) continue;
      const Eigen::Vector2d change = b.out_of_line - a.out_of_line;
      const double share = -a.out_of_line.dot(change) / change.squaredNorm();
      if (!(share >= 0 && share < 1) || (a.out_of_line + share * change).norm() > kNearlyInLine) continue;
      const Root root = rootAt(a.arm + share * way, turnAt(goal, from_roll + share * (to_roll - from_roll)));
      const double q5 = ahead + (w4.dot(root.turn * w6) < 0 ? kFullTurn / 2 : 0);
      for (int k = 0; k < kTurnsInLine; ++k) postures.push_back(withWrist(root, k * kFullTurn / kTurnsInLine, q5));
    }
}

void WristBranches::addPostures(const ToolGoal& goal, std::span<const double> rolls, double most_imaginary,
                                std::vector<VectorXd>& postures) const {
  if (last_turns_in_place_) {
    const std::size_t first = postures.size();
    for (const Root& root : rootsAt(goal, 0, most_imaginary)) addWrists(root, 0, postures);
    const std::vector<VectorXd> turned(postures.begin() + static_cast<std::ptrdiff_t>(first), postures.end());
    postures.resize(first);
    for (const double roll : rolls)
      for (const VectorXd& q : turned) postures.push_back(q), postures.back()[5] = roll;
    return;
  }
  std::vector<std::vector<Root>> roots;
  for (const double roll : rolls) roots.push_back(rootsAt(goal, roll, most_imaginary));
  for (std::size_t k = 0; k < rolls.size(); ++k) {
    for (const Root& root : roots[k]) addWrists(root, 0, postures);
    if (rolls.size() == 1) return;
    const std::size_t before = k == 0 ? rolls.size() - 1 : k - 1;
    const double roll_before = rolls[before] - (k == 0 ? kFullTurn : 0);
    addInLineBetween(goal, roots[before], roll_before, roots[k], rolls[k], postures);
  }
}

void WristBranches::addPosturesLike(const ToolGoal& goal, const VectorXd& q, double most_imaginary,
                                    std::vector<VectorXd>& postures) const {
  if (last_turns_in_place_) return addPostures(goal, std::span(&q[5], 1), most_imaginary, postures);
  const double roll =
      turnBetween(goal.axis_B, goal.axis_B.unitOrthogonal(), turnOf(axes_, q) * axes_.tool_axis.unitOrthogonal());
  for (const Root& root : rootsAt(goal, roll, most_imaginary)) addWrists(root, q[3], postures);
}

}  // namespace tubeplan::deflection
