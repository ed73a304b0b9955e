#include "deflection/posture_batch.hpp"

#include <algorithm>
#include <cassert>

#include "deflection/hinges/hinge_chain.hpp"
#include "deflection/hinges/kernels.hpp"

namespace tubeplan::deflection {

using Eigen::Index, Eigen::Vector3d;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kMostLanes = 8;

/// Columns of a matrix that stands row by row: `count` of them from `first`, as `width` lanes; the last one again where
/// there are fewer.
void copyIn(const Side& from, Index first, Index count, Index width, double* to) {
  for (Index row = 0; row < from.rows(); ++row)
    for (Index l = 0; l < width; ++l) to[row * width + l] = from(row, first + std::min(l, count - 1));
}

void copyOut(const double* from, Index first, Index count, Index width, Side& to) {
  for (Index row = 0; row < to.rows(); ++row)
    for (Index l = 0; l < count; ++l) to(row, first + l) = from[row * width + l];
}

/// The last postures of a batch, fewer than lanes.
void solveRest(const hinges::Kernel& kernel, const hinges::HingeArm& arm, const PostureBatch& postures, Index first,
               const FlexibleKinematicsOptions& options, bool derive, TipBatch& tips, double* sweeps) {
  double q[hinges::kMaxJoints * kMostLanes], load[kMostLanes], gravity[3 * kMostLanes], pose[12 * kMostLanes],
      jacobian[6 * hinges::kMaxJoints * kMostLanes], took[kMostLanes];
  const Index count = postures.size() - first, width = kernel.lanes;
  copyIn(postures.q, first, count, width, q);
  copyIn(postures.gravity_B, first, count, width, gravity);
  for (Index l = 0; l < width; ++l) load[l] = postures.load[first + std::min(l, count - 1)];
  kernel.solve(arm, {q, load, gravity, width, options.tolerance * arm.reach, options.max_iterations},
               {pose, derive ? jacobian : nullptr, took, nullptr, width});
  copyOut(pose, first, count, width, tips.poses);
  if (derive) copyOut(jacobian, first, count, width, tips.jacobian);
  std::copy_n(took, count, sweeps + first);
}

}  // namespace

void PostureBatch::resize(Index joints, Index count, double load_of_all, const Vector3d& gravity_of_all) {
  q.resize(joints, count);
  load.setConstant(count, load_of_all);
  gravity_B = gravity_of_all.replicate(1, count);
}

PoseOf<double> TipBatch::X_BD(Index k) const {
  PoseOf<double> X;
  X.p = poses.col(k).head<3>();
  for (int column = 0; column < 3; ++column) X.R.col(column) = poses.col(k).segment<3>(3 + 3 * column);
  return X;
}

BatchKinematics::BatchKinematics(const Arm& arm) : arm_(arm), variables_(jointVariables(arm)) {
  if (!arm_.hasJacobian()) tip_.emplace(arm);
}

int BatchKinematics::lanes() const { return tip_ ? 1 : hinges::kernels().back().lanes; }

void BatchKinematics::solve(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options) {
  run(postures, tips, options, false);
}

void BatchKinematics::solveWithJacobian(const PostureBatch& postures, TipBatch& tips,
                                        const FlexibleKinematicsOptions& options) {
  run(postures, tips, options, true);
}

void BatchKinematics::run(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                          bool derive) {
  const Index n = postures.size(), joints = static_cast<Index>(variables_.size());
  assert(postures.q.rows() == joints && postures.load.size() == n && postures.gravity_B.cols() == n);
  tips.status.assign(static_cast<std::size_t>(n), KinematicsStatus::kNotRun);
  tips.poses.resize(12, n);
  tips.jacobian.resize(derive ? 6 * joints : 0, n);
  if (n == 0) return;
  if (!tip_)
    solveSideBySide(postures, tips, options, derive);
  else
    solveOneByOne(postures, tips, options, derive);
  for (Index k = 0; k < n; ++k) {
    if (tips.status[static_cast<std::size_t>(k)] == KinematicsStatus::kConverged) continue;
    tips.poses.col(k).setConstant(kNaN);
    tips.jacobian.col(k).setConstant(kNaN);
  }
}

void BatchKinematics::solveSideBySide(const PostureBatch& postures, TipBatch& tips,
                                      const FlexibleKinematicsOptions& options, bool derive) {
  const hinges::Kernel& kernel = hinges::kernels().back();
  const hinges::HingeArm arm = arm_.hinges()->numbers();
  const Index n = postures.size();
  sweeps_.resize(static_cast<std::size_t>(n));
  Index k = 0;
  for (; k + kernel.lanes <= n; k += kernel.lanes)
    kernel.solve(arm,
                 {postures.q.data() + k, postures.load.data() + k, postures.gravity_B.data() + k, n,
                  options.tolerance * arm.reach, options.max_iterations},
                 {tips.poses.data() + k, derive ? tips.jacobian.data() + k : nullptr, sweeps_.data() + k, nullptr, n});
  if (k < n) solveRest(kernel, arm, postures, k, options, derive, tips, sweeps_.data());
  for (std::size_t i = 0; i < sweeps_.size(); ++i)
    tips.status[i] = sweeps_[i] < 0 ? KinematicsStatus::kNotConverged : KinematicsStatus::kConverged;
}

void BatchKinematics::solveOneByOne(const PostureBatch& postures, TipBatch& tips,
                                    const FlexibleKinematicsOptions& options, bool derive) {
  static const std::vector<Variable> kNone;
  for (Index k = 0; k < postures.size(); ++k) {
    const Posture posture{postures.q.col(k), postures.load[k], postures.gravity_B.col(k)};
    tips.status[static_cast<std::size_t>(k)] = tip_->solve(posture, derive ? variables_ : kNone, options);
    const PoseOf<double>& X = tip_->arm().X_BD();
    tips.poses.col(k).head<3>() = X.p;
    tips.poses.col(k).tail<9>() = X.R.reshaped();
    if (derive) tips.jacobian.col(k) = tip_->columns().reshaped();
  }
}

}  // namespace tubeplan::deflection
