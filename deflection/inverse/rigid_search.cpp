#include "deflection/inverse/rigid_search.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "deflection/inverse/turret_branches.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
constexpr int kProbes = 8;              ///< number of postures at which the tip's derivatives are examined
constexpr double kTurnsTheTool = 1e-3;  ///< smallest singular value of slopesAt() for an arm that can orient its tool
constexpr double kNearlyReal = 0.2;     ///< largest imaginary part of complex roots that are used [rad]
/// Number of slices. In a slice, the held joints and the tool's rotation about its axis are fixed. The numbers are for
/// turret arms, which have a closed form; for one redundant joint; for several redundant joints.
constexpr int kTurretSlices = 96, kSlicesOfOne = 24, kSlicesOfMore = 48;
constexpr std::size_t kStride = 31;  ///< index step between tool rotations of successive slices; coprime to their count

AxesAtZero withJointHeld(AxesAtZero axes, std::size_t held, double q) {
  const Vector3d direction = axes.direction[held], point = axes.point[held];
  const bool slides = axes.slides[held];
  const Eigen::Matrix3d R = slides ? Eigen::Matrix3d::Identity() : Eigen::AngleAxisd(q, direction).toRotationMatrix();
  const Vector3d p = slides ? Vector3d(q * direction) : Vector3d(point - R * point);
  const auto place = [&](Vector3d& at) { at = R * at + p; };
  for (std::size_t k = held + 1; k < axes.point.size(); ++k) {
    place(axes.point[k]);
    axes.direction[k] = R * axes.direction[k];
  }
  place(axes.tip);
  axes.tool_axis = R * axes.tool_axis;
  const auto at = static_cast<std::ptrdiff_t>(held);
  axes.point.erase(axes.point.begin() + at);
  axes.direction.erase(axes.direction.begin() + at);
  axes.slides.erase(axes.slides.begin() + at);
  return axes;
}

/// Returns derivatives with respect to the joints. The first three rows are for the tip position divided by the reach,
/// the last two for the tool's rotation about two directions perpendicular to its axis.
MatrixXd slopesAt(const AxesAtZero& axes, const VectorXd& q, double reach) {
  TipMotion tip;
  placeRigidTip(axes, q, tip);
  for (Index k = 0; k < q.size(); ++k)
    if (axes.slides[static_cast<std::size_t>(k)]) tip.columns.col(k) *= reach;
  const Vector3d u = tip.axis.unitOrthogonal();
  MatrixXd slopes(5, q.size());
  slopes.topRows<3>() = tip.columns.topRows<3>() / reach;
  slopes.row(3) = u.transpose() * tip.columns.bottomRows<3>();
  slopes.row(4) = tip.axis.cross(u).transpose() * tip.columns.bottomRows<3>();
  return slopes;
}

std::vector<MatrixXd> slopesAtProbes(const Arm& arm, const AxesAtZero& axes, double reach) {
  std::vector<MatrixXd> slopes;
  const auto joints = static_cast<Index>(axes.point.size());
  for (const VectorXd& q : latticeStarts(arm, kProbes)) slopes.push_back(slopesAt(axes, q.head(joints), reach));
  return slopes;
}

double leastSingularValue(const MatrixXd& m) { return Eigen::JacobiSVD<MatrixXd>(m).singularValues().minCoeff(); }

std::vector<double> turnsRound(int count) {
  std::vector<double> turns;
  for (int k = 0; k < count; ++k) turns.push_back(kFullTurn * k / count);
  return turns;
}

/// Returns the joints to hold. With these, the first `rows` rows of the other joints' derivatives are as far from
/// singular as possible, on average over the probes.
std::vector<int> heldJoints(const std::vector<MatrixXd>& slopes, Index rows) {
  const Index n = slopes.front().cols();
  double best = -1;
  std::vector<int> chosen;
  for (unsigned held = 0; held < 1U << n; ++held) {
    std::vector<int> out, kept;
    for (int k = 0; k < n; ++k) (held >> k & 1U ? out : kept).push_back(k);
    if (static_cast<Index>(kept.size()) != rows) continue;
    double score = 0;
    for (const MatrixXd& slope : slopes)
      score += std::pow(std::abs(slope(Eigen::seqN(0, rows), kept).determinant()), 1. / static_cast<double>(rows));
    if (score > best * (1 + 1e-9)) best = score, chosen = out;
  }
  return chosen;
}

}  // namespace

RigidSearch::RigidSearch(const Arm& arm, const AxesAtZero& axes, Constraint constraint)
    : axes_(axes), reach_(reachOf(arm)) {
  chooseForm(arm, constraint);
  if (form_ == Form::kLine) lines_ = closureChain<kLineSize>(axes_, reach_);
  if (form_ == Form::kPlace) places_ = closureChain<kPlaceSize>(axes_, reach_);
  addSlices(arm);
}

/// Adds slices at the readings of an even lattice within the limits; only the readings of held joints matter.
void RigidSearch::addSlices(const Arm& arm) {
  const bool has_wrist = form_ == Form::kWrist;
  if (held_.empty()) {
    slices_.push_back(sliceAt({}, has_wrist ? turnsRound(kSlicesOfOne) : std::vector<double>()));
    return;
  }
  const int count = form_ == Form::kTurret            ? kTurretSlices
                    : held_.size() == 1 && !has_wrist ? kSlicesOfOne
                                                      : kSlicesOfMore;
  const std::vector<double> rolls = turnsRound(count);
  // Each lattice point gets a different rotation of the tool. The stride decorrelates the rotations from the readings.
  std::size_t next = 0;
  for (const VectorXd& q : latticeStarts(arm, count)) {
    slices_.push_back(sliceAt(q(held_), has_wrist ? std::vector{rolls[next % rolls.size()]} : std::vector<double>()));
    next += kStride;
  }
}

void RigidSearch::chooseForm(const Arm& arm, Constraint constraint) {
  const Index n = arm.jointCount();
  assert(n >= 3);
  if (constraint == Constraint::kPlaceAndAxis && n >= 4) {
    for (int k = 1; k + 3 < n; ++k) held_.push_back(k);
    AxesAtZero four = axes_;
    for (std::size_t k = held_.size(); k-- > 0;)
      four = withJointHeld(std::move(four), static_cast<std::size_t>(held_[k]), 0);
    form_ = Form::kTurret;
    if (carriesPlane(four)) return;
    form_ = Form::kWrist;
    if (carriesWrist(axes_, reach_)) {
      held_ = heldJoints(slopesAtProbes(arm, axesBeforeWrist(axes_), reach_), 3);
      return;
    }
  }
  const std::vector<MatrixXd> slopes = slopesAtProbes(arm, axes_, reach_);
  const bool turns_the_tool = n >= 5 && std::ranges::any_of(slopes, [](const MatrixXd& slope) {
                                return leastSingularValue(slope) > kTurnsTheTool;
                              });
  form_ = constraint == Constraint::kPlaceAndAxis && turns_the_tool ? Form::kLine : Form::kPlace;
  held_ = heldJoints(slopes, form_ == Form::kLine ? 5 : 3);
}

RigidSearch::Slice RigidSearch::sliceAt(const VectorXd& readings, std::vector<double> rolls) const {
  const auto held = [&](auto chain) {
    for (std::size_t k = held_.size(); k-- > 0;)
      chain = withJointHeld(std::move(chain), static_cast<std::size_t>(held_[k]), readings[static_cast<Index>(k)]);
    return chain;
  };
  if (form_ == Form::kLine) return {readings, LineLoop(held(*lines_)), {}};
  if (form_ == Form::kPlace) return {readings, PlaceLoop(held(*places_)), {}};
  if (form_ == Form::kWrist) return {readings, WristBranches(held(axes_), reach_), std::move(rolls)};
  return {readings, held(axes_), {}};
}

/// Returns the readings of the joints that are not held.
VectorXd RigidSearch::withoutHeld(const VectorXd& q) const {
  std::vector<int> kept;
  for (int k = 0; k < q.size(); ++k)
    if (std::ranges::find(held_, k) == held_.end()) kept.push_back(k);
  return q(kept);
}

void RigidSearch::addAt(const Slice& slice, std::span<const VectorXd> found, std::vector<VectorXd>& postures) const {
  for (const VectorXd& some : found) {
    VectorXd q(some.size() + slice.readings.size());
    for (Index k = 0, held = 0; k < q.size(); ++k) {
      const bool is_held = held < slice.readings.size() && held_[static_cast<std::size_t>(held)] == k;
      q[k] = is_held ? slice.readings[held] : some[k - held];
      held += is_held ? 1 : 0;
    }
    postures.push_back(std::move(q));
  }
}

void RigidSearch::addFrom(const Slice& slice, const ToolGoal& goal, double most_imaginary,
                          std::vector<VectorXd>& postures) const {
  std::vector<VectorXd> found;
  if (const auto* turret = std::get_if<AxesAtZero>(&slice.chain)) addTurretBranches(*turret, goal, found);
  if (const auto* wrist = std::get_if<WristBranches>(&slice.chain))
    wrist->addPostures(goal, slice.rolls, most_imaginary, found);
  if (const auto* line = std::get_if<LineLoop>(&slice.chain))
    line->addRoots(goal.p_BT, goal.axis_B, most_imaginary, found);
  if (const auto* place = std::get_if<PlaceLoop>(&slice.chain))
    place->addRoots(goal.p_BT, goal.axis_B, most_imaginary, found);
  addAt(slice, found, postures);
}

void RigidSearch::addPostures(const ToolGoal& goal, std::vector<VectorXd>& postures) const {
  // Complex roots are not needed if slices sample the redundancy, because postures that nearly coincide in one slice
  // are distinct in the next.
  const double most_imaginary = isContinuum() ? 0 : kNearlyReal;
  for (const Slice& slice : slices_) addFrom(slice, goal, most_imaginary, postures);
}

void RigidSearch::addPosturesLike(const ToolGoal& goal, const VectorXd& q, std::vector<VectorXd>& postures) const {
  const Slice slice = sliceAt(q(held_));
  const auto* wrist = std::get_if<WristBranches>(&slice.chain);
  if (!wrist) return addFrom(slice, goal, kNearlyReal, postures);
  std::vector<VectorXd> found;
  wrist->addPosturesLike(goal, withoutHeld(q), kNearlyReal, found);
  addAt(slice, found, postures);
}

}  // namespace tubeplan::deflection
