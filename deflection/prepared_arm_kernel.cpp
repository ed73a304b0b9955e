// The part of PreparedArm that passes an arm of revolute joints to a kernel, and reads the kernel's results.
#include <cassert>

#include "deflection/prepared_arm.hpp"
#include "deflection/revolute_chain/kernels.hpp"
#include "deflection/revolute_chain/revolute_variables.hpp"

namespace tubeplan::deflection {

using Eigen::Vector3d;

void PreparedArm::findRevoluteChain(const Arm& arm) {
  revolute_chain_.reset();
  const auto& tip = arm.tip_load;
  const bool tip_is_loaded = tip && !(tip->contact_force == 0 && tip->payload_offset.isZero(0));
  if (hasFollowers(arm)) return;
  if (equilibrium_.loads.size() > 1 || equilibrium_.clearances > 0 || tip_is_loaded) return;
  std::vector<int> joint_of(chain_.links.size(), -1);
  for (const JointTurn& turn : turns_) joint_of[turn.link] = turn.joint;
  auto found = simd::RevoluteChain::of(chain_, arm, joint_of, equilibrium_.elements, equilibrium_.reach);
  if (!found) return;
  revolute_chain_ = std::make_unique<const simd::RevoluteChain>(std::move(*found));
  element_states_.resize(4 * static_cast<std::size_t>(revolute_chain_->numbers().count));
}

bool PreparedArm::hasJacobian() const { return is_prepared_ && revolute_chain_ && revolute_chain_->hasJacobian(); }

const simd::RevoluteChain* PreparedArm::revoluteChain() const { return is_prepared_ ? revolute_chain_.get() : nullptr; }

const simd::RevoluteVariables* PreparedArm::kernelFor(const std::vector<Variable>& variables) {
  if (!hasJacobian()) return nullptr;
  if (!simd::areSame(variables, kernel_variables_)) {
    const auto found = simd::RevoluteVariables::of(variables, arm_, chain_, *revolute_chain_, equilibrium_.elements);
    kernel_ = found ? std::make_unique<const simd::RevoluteVariables>(*found) : nullptr;
    kernel_variables_ = variables;
  }
  return kernel_.get();
}

/// Solves with a kernel. `out` holds the pointers for derivatives; null if none are needed.
KinematicsStatus PreparedArm::solveRevoluteChain(const FlexibleKinematicsOptions& options, simd::Shapes out) {
  const simd::RevoluteArm arm = revolute_chain_->numbers();
  const Posture& posture = effectivePosture();
  assert(posture.q.size() == arm.joints);
  double pose[12], sweeps = 0;
  out.pose = pose;
  out.sweeps = &sweeps;
  out.element_states = element_states_.data();
  out.stride = out.derivative_stride = 1;
  simd::kernels().front().solve(arm,
                                {posture.q.data(), &posture.load, posture.gravity_B.data(), 1,
                                 options.tolerance * arm.reach, options.max_iterations},
                                out);
  X_BD_.p = Eigen::Map<const Vector3d>(pose);
  X_BD_.R = Eigen::Map<const Eigen::Matrix3d>(pose + 3);
  if (context_) X_BD_ = context_->X_BM * X_BD_;
  is_copied_out_ = false;
  iterations_ = sweeps < 0 ? options.max_iterations : (static_cast<int>(sweeps) + 1) / 2;
  status_ = sweeps < 0 ? KinematicsStatus::kNotConverged : KinematicsStatus::kConverged;
  return status_;
}

KinematicsStatus PreparedArm::solveWithDerivatives(const Posture& posture, const FlexibleKinematicsOptions& options,
                                                   const simd::RevoluteVariables& variables, double* derivatives) {
  assert(hasJacobian());
  nominal_posture_ = posture;
  simd::Shapes out{};
  variables.place(derivatives, 1, out);
  return solveRevoluteChain(options, out);
}

/// Copies the deflections of the elements from the kernel's results, and computes the loads on the elements.
void PreparedArm::copyOutElements() const {
  if (is_copied_out_) return;
  is_copied_out_ = true;
  pose(effectivePosture().q);
  load(effective(), effectivePosture());
  revolute_chain_->copyDeflections(element_states_.data(), 1, equilibrium_.elements);
  equilibrium_.carryLoads();
}

}  // namespace tubeplan::deflection
