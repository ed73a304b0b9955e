// Random arms of one to nine rows with joints of any kind, and with springs, beams, weights and side chains anywhere.
//
// The arms are the same in every run; RC_PARAMS="seed=2 max_success=10000" tests other arms and reduces failures to
// small cases.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "deflection/flexible_kinematics.hpp"
#include "deflection/side_chains.hpp"
#include "tests/deflection/central_difference.hpp"

namespace tubeplan::deflection {

[[maybe_unused]] inline const bool kIsSeeded = setenv("RC_PARAMS", "seed=20 max_success=300", 0) == 0;

/// Returns a uniformly distributed integer from 0 to end - 1, independent of RapidCheck's size parameter.
inline int below(int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); }
inline double between(double low, double high) { return low + (high - low) * below(1001) / 1000; }
inline bool happens(double share) { return below(1000) < 1000 * share; }
inline Eigen::Vector3d vectorIn(double size) {
  return {between(-size, size), between(-size, size), between(-size, size)};
}

inline Row<double> randomRow(int index) {
  Row<double> row;
  row.name = "row" + std::to_string(index);
  if (happens(0.5))
    row.placement = DenavitHartenberg<double>{between(-3, 3), between(0, 1), between(-0.5, 0.5), between(-3, 3),
                                              happens(0.5) ? between(-0.3, 0.3) : 0};
  else
    row.placement = Origin<double>{vectorIn(0.7), vectorIn(3), happens(0.3) ? between(-0.3, 0.3) : 0};
  const int kind = index == 1 ? 0 : below(8);
  row.joint.type = kind < 6 ? JointType::kRevolute : kind == 6 ? JointType::kPrismatic : JointType::kPassive;
  if (row.joint.type == JointType::kPassive) return row;
  row.joint.name = "joint" + std::to_string(index);
  row.joint.lower = row.joint.type == JointType::kRevolute ? -3 : 0.05;
  row.joint.upper = row.joint.type == JointType::kRevolute ? 3 : 0.8;
  row.joint.offset = between(-0.04, 0.1);  // keeps a prismatic joint's length positive: the tip has a kink at zero
  return row;
}

inline void addSoftness(Arm& arm, int index) {
  Row<double>& row = arm.rows[static_cast<std::size_t>(index)];
  for (int axis = 0; axis < 3; ++axis)
    if (happens(0.3)) row.joint_stiffness[axis] = std::pow(10, between(4.5, 7.5));
  const Eigen::Vector3d member = undeflectedMember(arm, index);
  if (member.norm() < 0.05 || !happens(0.4)) return;
  row.beam = Beam<double>{.E = 7e10, .segments = 1 + below(3)};
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(member.normalized()[axis]) < 0.99 && happens(0.7)) row.beam->I[axis] = std::pow(10, between(-6.5, -4));
  if (row.beam->I.array().isInf().all()) row.beam->E = kRigid;
  if (!happens(0.5) && !row.beam->I.array().isInf().all()) return;
  row.beam->G = 2.6e10;
  row.beam->J = std::pow(10, between(-6.5, -4));
}

inline void addWeights(Row<double>& row) {
  if (happens(0.7)) row.weight.distributed = between(0, 80);
  if (happens(0.3)) row.weight.end = between(0, 60);
  for (int k = below(3); k > 0; --k) row.weight.lumps.push_back({between(0, 80), vectorIn(0.3)});
}

inline Arm randomArm() {
  Arm arm;
  const int rows = 1 + below(9);
  for (int k = 1; k <= rows; ++k) arm.rows.push_back(randomRow(k));
  arm.p_LT = vectorIn(0.4);
  for (int k = 0; k < rows; ++k) {
    addSoftness(arm, k);
    addWeights(arm.rows[static_cast<std::size_t>(k)]);
  }
  if (happens(0.2)) {
    arm.side_chains = {{below(rows), {randomRow(50), randomRow(51)}}};
    arm.side_chains[0].rows[1].weight.end = 40;
  }
  RC_ASSERT(findProblems(arm).empty());
  return arm;
}

inline Eigen::VectorXd randomReadings(const std::vector<const Joint<double>*>& joints) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = between(joints[static_cast<std::size_t>(k)]->lower, joints[static_cast<std::size_t>(k)]->upper);
  return q;
}

inline Posture randomPostureOf(const Arm& arm, double most_load) {
  std::vector<const Joint<double>*> joints;
  for (const auto& joint : arm.joints()) joints.push_back(&joint);
  Posture posture{randomReadings(joints), between(0, most_load), Eigen::Vector3d::UnitX()};
  posture.gravity_B = rotationFromFixedAngles<double>(vectorIn(3)) * posture.gravity_B;
  posture.side_q = randomReadings(sideJoints(arm));
  if (happens(0.5)) posture.wrench = Wrench{most_load * vectorIn(1), 0.3 * most_load * vectorIn(1)};
  return posture;
}

inline bool isModest(const Arm& arm, const FlexibleKinematics& shape) {
  return shape.status == KinematicsStatus::kConverged && (shape.X_BD.p - shape.X_BT.p).norm() < 0.02 * reachOf(arm);
}

/// Returns true if column `k` of the derivatives agrees with the difference quotient of its variable, for the better of
/// two steps. The long step is inaccurate if the arm bends strongly.
inline bool isExact(const Arm& arm, const Posture& posture, const TipDerivatives& exact, std::size_t k,
                    const Variable& variable, double h) {
  const double reach = reachOf(arm);
  const auto column = static_cast<Eigen::Index>(k);
  const auto agrees = [&](double step_size) {
    const Difference d = centralDifference(arm, posture, variable, step_size);
    const double off =
        (d.position - exact.position_B.col(column)).norm() + reach * (d.rotation - exact.rotation_B.col(column)).norm();
    return off <= 1e-5 * (d.position.norm() + reach * d.rotation.norm()) + 1e-11 * reach / step_size;
  };
  return agrees(h) || agrees(h / 5);
}

}  // namespace tubeplan::deflection
