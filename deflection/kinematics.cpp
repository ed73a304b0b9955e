#include "deflection/kinematics.hpp"

#include <algorithm>
#include <cassert>

#include "deflection/resized.hpp"
#include "deflection/revolute_chain/kernels.hpp"
#include "deflection/revolute_chain/revolute_chain.hpp"

namespace tubeplan::deflection {

using Eigen::Index, Eigen::Vector3d;
using simd::kMostLanes;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Copies `count` columns of a row-major matrix, starting at `first`, to `width` lanes; surplus lanes repeat the last
/// column.
void copyIn(const Side& from, Index first, Index count, Index width, double* to) {
  for (Index row = 0; row < from.rows(); ++row)
    for (Index l = 0; l < width; ++l) to[row * width + l] = from(row, first + std::min(l, count - 1));
}

void copyOut(const double* from, Index first, Index count, Index width, Side& to) {
  for (Index row = 0; row < to.rows(); ++row)
    for (Index l = 0; l < count; ++l) to(row, first + l) = from[row * width + l];
}

/// Solves the remaining postures of a batch, which are fewer than the kernel's lanes. Derivatives stay in lane layout
/// in `out`.
void solveRest(const simd::Kernel& kernel, const simd::RevoluteArm& arm, const PostureBatch& postures, Index first,
               const FlexibleKinematicsOptions& options, TipBatch& tips, double* sweeps, simd::Shapes out) {
  double q[simd::kMaxJoints * kMostLanes], load[kMostLanes], gravity[3 * kMostLanes], pose[12 * kMostLanes],
      took[kMostLanes];
  const Index count = postures.size() - first, width = kernel.lanes;
  copyIn(postures.q, first, count, width, q);
  copyIn(postures.gravity_B, first, count, width, gravity);
  for (Index l = 0; l < width; ++l) load[l] = postures.load[first + std::min(l, count - 1)];
  out.pose = pose;
  out.sweeps = took;
  out.stride = width;
  kernel.solve(arm, {q, load, gravity, width, options.tolerance * arm.reach, options.max_iterations}, out);
  copyOut(pose, first, count, width, tips.poses);
  std::copy_n(took, count, sweeps + first);
}

}  // namespace

Kinematics::Kinematics(const Arm& arm) : given_(arm), arm_(arm), joints_(jointVariables(arm)) {}

void Kinematics::solve(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options) {
  static const std::vector<Variable> kNone;
  run(postures, tips, options, kNone);
}

void Kinematics::solveWithJacobian(const PostureBatch& postures, TipBatch& tips,
                                   const FlexibleKinematicsOptions& options) {
  run(postures, tips, options, joints_);
}

void Kinematics::solveWithDerivatives(const PostureBatch& postures, const std::vector<Variable>& variables,
                                      TipBatch& tips, const FlexibleKinematicsOptions& options) {
  run(postures, tips, options, variables);
}

bool Kinematics::hasKernel(const std::vector<Variable>& variables) {
  return variables.empty() ? arm_.hasJacobian() : arm_.kernelFor(variables) != nullptr;
}

void Kinematics::run(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                     const std::vector<Variable>& variables) {
  const Index n = postures.size();
  assert(postures.q.rows() == static_cast<Index>(joints_.size()) && postures.load.size() == n &&
         postures.gravity_B.cols() == n);
  tips.status.assign(static_cast<std::size_t>(n), KinematicsStatus::kNotRun);
  resizeOrEmpty(tips.poses, 12, n);
  resizeOrEmpty(tips.jacobian, 6 * static_cast<Index>(variables.size()), n);
  if (n == 0) return;
  if (hasKernel(variables))
    solveSideBySide(postures, tips, options, variables);
  else
    solveOneByOne(postures, tips, options, variables);
  for (Index k = 0; k < n; ++k) {
    if (tips.status[static_cast<std::size_t>(k)] == KinematicsStatus::kConverged) continue;
    tips.poses.col(k).setConstant(kNaN);
    if (!variables.empty()) tips.jacobian.col(k).setConstant(kNaN);
  }
}

void Kinematics::solveSideBySide(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                                 const std::vector<Variable>& variables) {
  const simd::RevoluteVariables* derived = variables.empty() ? nullptr : arm_.kernelFor(variables);
  if (derived) derivatives_.resize(static_cast<std::size_t>(6 * kMostLanes * derived->columns()));
  const simd::RevoluteArm arm = arm_.revoluteChain()->numbers();
  const Index n = postures.size();
  sweeps_.resize(static_cast<std::size_t>(n));
  simd::Shapes out{};
  for (Index k = 0; k < n;) {
    const simd::Kernel& kernel = simd::kernelFor(static_cast<int>(n - k));
    const Index count = std::min<Index>(kernel.lanes, n - k);
    if (derived) derived->place(derivatives_.data(), kernel.lanes, out);
    if (count < kernel.lanes) {
      solveRest(kernel, arm, postures, k, options, tips, sweeps_.data(), out);
    } else {
      out.pose = tips.poses.data() + k;
      out.sweeps = sweeps_.data() + k;
      out.stride = n;
      kernel.solve(arm,
                   {postures.q.data() + k, postures.load.data() + k, postures.gravity_B.data() + k, n,
                    options.tolerance * arm.reach, options.max_iterations},
                   out);
    }
    for (std::size_t v = 0; v < variables.size(); ++v)
      derived->gather(v, derivatives_.data(), kernel.lanes, count,
                      tips.jacobian.data() + 6 * static_cast<Index>(v) * n + k, n);
    k += count;
  }
  for (std::size_t i = 0; i < sweeps_.size(); ++i)
    tips.status[i] = sweeps_[i] < 0 ? KinematicsStatus::kNotConverged : KinematicsStatus::kConverged;
}

void Kinematics::solveOneByOne(const PostureBatch& postures, TipBatch& tips, const FlexibleKinematicsOptions& options,
                               const std::vector<Variable>& variables) {
  if (!tip_) tip_.emplace(given_);
  for (Index k = 0; k < postures.size(); ++k) {
    const Posture posture{postures.q.col(k), postures.load[k], postures.gravity_B.col(k)};
    tips.status[static_cast<std::size_t>(k)] = tip_->solve(posture, variables, options);
    const PoseOf<double>& X = tip_->arm().X_BD();
    tips.poses.col(k).head<3>() = X.p;
    tips.poses.col(k).tail<9>() = X.R.reshaped();
    if (!variables.empty()) tips.jacobian.col(k) = tip_->columns().reshaped();
  }
}

}  // namespace tubeplan::deflection
