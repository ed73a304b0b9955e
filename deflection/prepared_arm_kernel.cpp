// The part of PreparedArm that hands an arm of hinges to a kernel, and takes what it has found.
#include <cassert>

#include "deflection/hinges/hinge_variables.hpp"
#include "deflection/hinges/kernels.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

using Eigen::Vector3d;

void PreparedArm::findHinges(const Arm& arm) {
  hinges_.reset();
  const auto& tip = arm.tip_load;
  const bool tip_pulls = tip && !(tip->contact_force == 0 && tip->payload_offset.isZero(0));
  if (hasFollowers(arm)) return;
  if (equilibrium_.loads.size() > 1 || equilibrium_.clearances > 0 || tip_pulls) return;
  std::vector<int> joint_of(chain_.links.size(), -1);
  for (const JointTurn& turn : turns_) joint_of[turn.link] = turn.joint;
  auto found = hinges::HingeChain::of(chain_, arm, joint_of, equilibrium_.elements, equilibrium_.reach);
  if (!found) return;
  hinges_ = std::make_unique<const hinges::HingeChain>(std::move(*found));
  gives_.resize(4 * static_cast<std::size_t>(hinges_->numbers().count));
}

bool PreparedArm::hasJacobian() const { return is_fixed_ && hinges_ && hinges_->hasJacobian(); }

const hinges::HingeChain* PreparedArm::hinges() const { return is_fixed_ ? hinges_.get() : nullptr; }

const hinges::HingeVariables* PreparedArm::kernelFor(const std::vector<Variable>& variables) {
  if (!hasJacobian()) return nullptr;
  if (!hinges::areSame(variables, kernel_asked_)) {
    const auto found = hinges::HingeVariables::of(variables, arm_, chain_, *hinges_, equilibrium_.elements);
    kernel_ = found ? std::make_unique<const hinges::HingeVariables>(*found) : nullptr;
    kernel_asked_ = variables;
  }
  return kernel_.get();
}

/// `out` says where derivatives are to go, if any.
KinematicsStatus PreparedArm::solveHinges(const FlexibleKinematicsOptions& options, hinges::Shapes out) {
  const hinges::HingeArm arm = hinges_->numbers();
  const Posture& posture = effectivePosture();
  assert(posture.q.size() == arm.joints);
  double pose[12], sweeps = 0;
  out.pose = pose;
  out.sweeps = &sweeps;
  out.gives = gives_.data();
  out.stride = out.derivative_stride = 1;
  hinges::kernels().front().solve(arm,
                                  {posture.q.data(), &posture.load, posture.gravity_B.data(), 1,
                                   options.tolerance * arm.reach, options.max_iterations},
                                  out);
  X_BD_.p = Eigen::Map<const Vector3d>(pose);
  X_BD_.R = Eigen::Map<const Eigen::Matrix3d>(pose + 3);
  if (situation_) X_BD_ = situation_->X_BM * X_BD_;
  is_told_ = false;
  iterations_ = sweeps < 0 ? options.max_iterations : (static_cast<int>(sweeps) + 1) / 2;
  status_ = sweeps < 0 ? KinematicsStatus::kNotConverged : KinematicsStatus::kConverged;
  return status_;
}

KinematicsStatus PreparedArm::solveWithDerivatives(const Posture& posture, const FlexibleKinematicsOptions& options,
                                                   const hinges::HingeVariables& variables, double* derivatives) {
  assert(hasJacobian());
  asked_ = posture;
  hinges::Shapes out{};
  variables.place(derivatives, 1, out);
  return solveHinges(options, out);
}

/// The elements as the kernel has found them, and the loads on them.
void PreparedArm::tellElements() const {
  if (is_told_) return;
  is_told_ = true;
  pose(effectivePosture().q);
  load(effective(), effectivePosture());
  hinges_->tell(gives_.data(), 1, equilibrium_.elements);
  equilibrium_.carryLoads();
}

}  // namespace tubeplan::deflection
