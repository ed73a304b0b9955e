#include "deflection/inverse/rigid_search.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "deflection/inverse/turret_branches.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
constexpr int kProbes = 8;              ///< postures at which an arm's freedom is looked at
constexpr double kTurnsTheTool = 1e-3;  ///< rad per rad, at the best of the probes: less is no freedom to turn the tool
constexpr double kNearlyReal = 0.2;     ///< rad of a complex root, that may be imaginary
/// Readings at which joints that are over are held: of turret arms, which have a closed form; of one joint; of more.
constexpr int kTurretSlices = 96, kSlicesOfOne = 24, kSlicesOfMore = 48;

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

/// What the joints do to the tip per reach and, in the last two rows, to the tool's axis across itself.
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

double leastSingularValue(const MatrixXd& m) { return Eigen::JacobiSVD<MatrixXd>(m).singularValues().minCoeff(); }

/// The joints to hold, that what the others do to the first `rows` of the slopes is as regular as may be on the whole.
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

RigidSearch::RigidSearch(const Arm& arm, const AxesAtZero& axes, Hold hold) : axes_(axes), reach_(reachOf(arm)) {
  chooseHeld(arm, hold);
  if (form_ == Form::kLine) lines_ = closureChain<kLineSize>(axes_, reach_);
  if (form_ == Form::kPlace) places_ = closureChain<kPlaceSize>(axes_, reach_);
  const int several = form_ == Form::kTurret ? kTurretSlices : held_.size() == 1 ? kSlicesOfOne : kSlicesOfMore;
  const int count = held_.empty() ? 1 : several;
  // Readings of an even lattice within the limits; only those of the joints that are held count.
  for (const VectorXd& q : latticeStarts(arm, count)) slices_.push_back(sliceAt(q(held_)));
}

void RigidSearch::chooseHeld(const Arm& arm, Hold hold) {
  const Index n = arm.jointCount();
  assert(n >= 3);
  if (hold == Hold::kPlaceAndAxis && n >= 4) {
    for (int k = 1; k + 3 < n; ++k) held_.push_back(k);
    AxesAtZero four = axes_;
    for (std::size_t k = held_.size(); k-- > 0;)
      four = withJointHeld(std::move(four), static_cast<std::size_t>(held_[k]), 0);
    form_ = Form::kTurret;
    if (carriesPlane(four)) return;
  }
  std::vector<MatrixXd> slopes;
  for (const VectorXd& q : latticeStarts(arm, kProbes)) slopes.push_back(slopesAt(axes_, q, reach_));
  const bool turns_the_tool = n >= 5 && std::ranges::any_of(slopes, [](const MatrixXd& slope) {
                                return leastSingularValue(slope) > kTurnsTheTool;
                              });
  form_ = hold == Hold::kPlaceAndAxis && turns_the_tool ? Form::kLine : Form::kPlace;
  held_ = heldJoints(slopes, form_ == Form::kLine ? 5 : 3);
}

RigidSearch::Slice RigidSearch::sliceAt(const VectorXd& readings) const {
  const auto held = [&](auto chain) {
    for (std::size_t k = held_.size(); k-- > 0;)
      chain = withJointHeld(std::move(chain), static_cast<std::size_t>(held_[k]), readings[static_cast<Index>(k)]);
    return chain;
  };
  if (form_ == Form::kLine) return {readings, LineLoop(held(*lines_))};
  if (form_ == Form::kPlace) return {readings, PlaceLoop(held(*places_))};
  return {readings, held(axes_)};
}

void RigidSearch::addFrom(const Slice& slice, const ToolGoal& goal, double most_imaginary,
                          std::vector<VectorXd>& postures) const {
  std::vector<VectorXd> found;
  if (const auto* turret = std::get_if<AxesAtZero>(&slice.chain)) addTurretBranches(*turret, goal, found);
  if (const auto* line = std::get_if<LineLoop>(&slice.chain))
    line->addRoots(goal.p_BT, goal.axis_B, most_imaginary, found);
  if (const auto* place = std::get_if<PlaceLoop>(&slice.chain))
    place->addRoots(goal.p_BT, goal.axis_B, most_imaginary, found);
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

void RigidSearch::addPostures(const ToolGoal& goal, std::vector<VectorXd>& postures) const {
  // Where a slice has two postures that are about to be one, the next slice has them apart.
  const double most_imaginary = held_.empty() ? kNearlyReal : 0;
  for (const Slice& slice : slices_) addFrom(slice, goal, most_imaginary, postures);
}

void RigidSearch::addPosturesAt(const ToolGoal& goal, const VectorXd& readings, std::vector<VectorXd>& postures) const {
  addFrom(sliceAt(readings), goal, kNearlyReal, postures);
}

}  // namespace tubeplan::deflection
