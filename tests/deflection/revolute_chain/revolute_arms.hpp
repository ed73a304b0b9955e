// Arms that kernels can solve, the same arms excluded from kernels, and batches of random postures.
#pragma once

#include <random>

#include "deflection/kinematics.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {

/// Returns an arm with all features that kernels support: beams in several pieces, a twisting beam, lumped weights, a
/// tilted tool, a spring about an axis perpendicular to its joint's axis, and a beam that does not start on its joint's
/// axis.
inline Arm asymmetricRevoluteArm() {
  Arm arm = cobraArm(3);
  arm.name = "odd";
  arm.rows[2].joint_stiffness[1] = 3e5;
  arm.rows[3].weight.lumps = {{70, {0.3, 0.05, 0.1}}};
  arm.rows[4].beam = Beam<double>{7e10, {kRigid, 3e-7, kRigid}, kRigid, kRigid, 2};
  arm.rows[4].weight.lumps = {{30, {0, 0.1, 0.05}}};
  arm.rows[5].beam = Beam<double>{kRigid, Eigen::Vector3d::Constant(kRigid), 2.6e10, 4e-8, 1};
  arm.rows[5].placement = Origin<double>{{0.49, 0.02, 0.03}, {0.2, -0.3, 0.1}};
  arm.rows[5].joint.offset = 0.05;
  return arm;
}

/// Returns an arm of skew beams, one of two segments, so that adjacent bending axes are parallel up to rounding.
inline Arm askewBeamArm() {
  Arm arm;
  arm.name = "askew beams";
  arm.rows = {originRow("boom", {-0.7, -0.7, -0.7}, {-3, -3, -3}, JointType::kRevolute),
              originRow("hand", Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), JointType::kPassive)};
  arm.rows[0].joint_stiffness.y() = 3e4;
  arm.rows[0].beam = Beam<double>{.E = 7e10, .I = {3.18053368833e-07, kRigid, kRigid}, .segments = 2};
  arm.rows[0].weight.lumps = {{20, {0.1152, -0.3, -0.282}}};
  arm.rows[1].placement = DenavitHartenberg<double>{-2.322, 0.778, -0.191, -3};
  arm.rows[1].beam = Beam<double>{.E = 7e10, .I = {kRigid, 3.16227766017e-07, kRigid}};
  arm.rows[1].weight.lumps = {{10, {-0.3, -0.3, -0.3}}};
  arm.p_LT = {-0.4, -0.4, -0.4};
  return arm;
}

inline std::vector<Arm> kernelArms() {
  return {cobraArm(), cobraArm(4), rigidCopy(cobraArm()), asymmetricRevoluteArm(), askewBeamArm()};
}

/// Returns the arm with a tip force too small to move it, which excludes the kernels, so that the general sweeps solve
/// it.
inline Arm withoutKernel(const Arm& arm) { return withEffect(arm, "contact-force", "tip", {1e-200}); }

inline Posture randomCase(const Arm& arm, std::mt19937_64& random) {
  std::uniform_real_distribution<double> load(0, 300);
  return {randomJoints(arm, random), load(random), randomDirection(random)};
}

inline PostureBatch randomBatch(const Arm& arm, Eigen::Index count, std::mt19937_64& random) {
  PostureBatch batch;
  batch.resize(arm.jointCount(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Posture posture = randomCase(arm, random);
    batch.q.col(k) = posture.q;
    batch.load[k] = posture.load;
    batch.gravity_B.col(k) = posture.gravity_B;
  }
  return batch;
}

inline Posture postureOf(const PostureBatch& batch, Eigen::Index k) {
  return {batch.q.col(k), batch.load[k], batch.gravity_B.col(k)};
}

}  // namespace tubeplan::deflection
