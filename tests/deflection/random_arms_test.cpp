// Laws that random arms must obey, even under loads far beyond what they can carry. If an arm has no shape, a status
// must state why.
#include "tests/deflection/random_arms.hpp"

#include <gtest/gtest.h>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/kinematics.hpp"
#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns the total weight of the arm, its side chains and its load [N].
double weightOf(const Arm& arm, const Posture& posture) {
  double weight = posture.load;
  const auto add = [&](const Row<double>& row, double length) {
    weight += row.weight.distributed * length + row.weight.end;
    for (const auto& lump : row.weight.lumps) weight += lump.weight;
  };
  Eigen::Index joint = 0;
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    double length = undeflectedMember(arm, static_cast<int>(k)).norm();
    const Row<double>& row = arm.rows[k];
    if (row.joint.type == JointType::kPrismatic) length = std::abs(posture.q[joint] + row.joint.offset);
    joint += row.joint.type != JointType::kPassive;
    add(row, length);
  }
  joint = 0;
  for (const auto& chain : arm.side_chains) weight += weightOfSideChain<double>(chain, posture.side_q, joint).weight;
  return weight;
}

RC_GTEST_PROP(RandomArms, RestInBalanceOrSayWhyNot, ()) {
  const Arm arm = randomArm();
  const Posture posture = randomPostureOf(arm, 20000);
  const auto shape = solveFlexibleKinematics(arm, posture);
  RC_CLASSIFY(shape.status == KinematicsStatus::kConverged, "converged");
  if (shape.status != KinematicsStatus::kConverged) {
    RC_ASSERT(shape.status == KinematicsStatus::kNotConverged);
    RC_ASSERT(!shape.reason.empty());
    return;
  }
  RC_ASSERT(shape.X_BD.p.allFinite());
  RC_ASSERT((shape.X_BD.R * shape.X_BD.R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  Eigen::Vector3d force = weightOf(arm, posture) * posture.gravity_B;
  if (posture.wrench) force += posture.wrench->force_B;
  RC_ASSERT((shape.rows.front().force_B - force).norm() <= 1e-9 * (1 + force.norm()));
}

RC_GTEST_PROP(RandomArms, TurnWithTheWorld, ()) {
  const Arm arm = randomArm();
  const Posture posture = randomPostureOf(arm, 300);
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  RC_PRE(isModest(arm, shape));
  const Eigen::Vector3d rpy = vectorIn(1.5);
  const Eigen::Matrix3d R = rotationFromFixedAngles<double>(rpy);
  Arm turned = arm;
  Row<double> foot;
  foot.name = "foot";
  foot.placement = Origin<double>{Eigen::Vector3d::Zero(), rpy};
  turned.rows.insert(turned.rows.begin(), foot);
  for (auto& chain : turned.side_chains) ++chain.row;
  Posture turned_posture = posture;
  turned_posture.gravity_B = R * posture.gravity_B;
  if (turned_posture.wrench) turned_posture.wrench = Wrench{R * posture.wrench->force_B, R * posture.wrench->moment_B};
  const auto other = solveFlexibleKinematics(turned, turned_posture, kTight);
  RC_ASSERT(other.status == KinematicsStatus::kConverged);
  RC_ASSERT((other.X_BD.p - R * shape.X_BD.p).norm() <= 1e-9 * reachOf(arm));
  RC_ASSERT((other.X_BD.R - R * shape.X_BD.R).norm() <= 1e-9);
}

RC_GTEST_PROP(RandomArms, HaveExactDerivatives, ()) {
  const Arm arm = randomArm();
  const Posture posture = randomPostureOf(arm, 300);
  RC_PRE(isModest(arm, solveFlexibleKinematics(arm, posture, kTight)));
  std::vector<Variable> variables = jointVariables(arm);
  variables.push_back(Variable::load());
  for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
  const auto numbers = parametersOf(arm);
  for (int k = 0; k < 3; ++k)
    variables.push_back(
        Variable::number(numbers[static_cast<std::size_t>(below(static_cast<int>(numbers.size())))].path));
  const auto exact = differentiateTip(arm, posture, variables, kTight);
  RC_ASSERT(exact.kinematics.status == KinematicsStatus::kConverged);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    Arm copy = arm;
    const bool is_number = variables[k].type == Variable::Type::kParameter;
    const double value = is_number ? std::abs(locate(copy, variables[k].parameter)) : 0;
    const bool is_stiffness =
        is_number && variables[k].parameter.effect < 0 &&
        isStiffness(parameterFields()[static_cast<std::size_t>(variables[k].parameter.field)].quantity);
    const double h = is_stiffness ? 1e-3 * value : variables[k].type == Variable::Type::kLoad ? 1 : 1e-4;
    RC_ASSERT(isExact(arm, posture, exact, k, variables[k], h));
  }
}

RC_GTEST_PROP(RandomArms, AreTheSameInABatchAndInAFile, ()) {
  const Arm arm = randomArm();
  Posture posture = randomPostureOf(arm, 300);
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  RC_PRE(isModest(arm, shape));
  const auto source = app::readArm(app::parseYaml(app::armYaml(arm, app::Units()), "arm.yaml"));
  const auto again = solveFlexibleKinematics(source.arm, posture, kTight);
  RC_ASSERT((again.X_BD.p - shape.X_BD.p).norm() <= 1e-9 * reachOf(arm));
  if (!arm.side_chains.empty()) return;
  posture.wrench.reset();
  PostureBatch batch;
  batch.resize(posture.q.size(), 3, posture.load, posture.gravity_B);
  for (Eigen::Index k = 0; k < 3; ++k) batch.q.col(k) = posture.q;
  Kinematics kinematics(arm);
  TipBatch tips;
  kinematics.solve(batch, tips, kTight);
  const auto bare = solveFlexibleKinematics(arm, posture, kTight);
  // A contact force, too small to move the arm, excludes the kernels.
  const Arm general = withEffect(arm, "contact-force", "tip", {1e-200});
  RC_ASSERT(bare.status == solveFlexibleKinematics(general, posture, kTight).status);
  RC_PRE(isModest(arm, bare));
  RC_ASSERT((bare.X_BD.p - solveFlexibleKinematics(general, posture, kTight).X_BD.p).norm() <= 1e-9 * reachOf(arm));
  for (std::size_t k = 0; k < 3; ++k) {
    RC_ASSERT(tips.status[k] == bare.status);
    RC_ASSERT((tips.X_BD(static_cast<Eigen::Index>(k)).p - bare.X_BD.p).norm() <= 1e-9 * reachOf(arm));
  }
}

RC_GTEST_PROP(RandomArms, FindTheirWayBackOrSayWhyNot, ()) {
  Arm arm = randomArm();
  arm.side_chains.clear();
  Posture posture = randomPostureOf(arm, 300);
  posture.wrench.reset();
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  RC_PRE(isModest(arm, shape));
  const ToolGoal goal{shape.X_BD.p, shape.X_BD.R * arm.tool_axis_L};
  Eigen::VectorXd start = posture.q;
  for (auto& q : start) q += between(-0.02, 0.02);
  const Branch branch = refineBranch(arm, goal, posture.load, posture.gravity_B, start);
  RC_CLASSIFY(branch.status == BranchStatus::kConverged, "converged");
  if (branch.status != BranchStatus::kConverged) {
    RC_ASSERT(branch.status != BranchStatus::kNotRun);
    RC_ASSERT(!branch.reason.empty());
    return;
  }
  posture.q = branch.q;
  const auto solved = solveFlexibleKinematics(arm, posture, kTight);
  RC_ASSERT((solved.X_BD.p - goal.p_BT).norm() <= 1e-9 * reachOf(arm));
  const double cosine = std::clamp((solved.X_BD.R * arm.tool_axis_L).dot(goal.axis_B), -1., 1.);
  RC_ASSERT(std::abs(std::acos(cosine) - branch.tilt) <= 1e-6);
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto& joint = arm.joint(k);
    const double q = branch.q[k];
    RC_ASSERT(q >= joint.lower - 1e-9 && q <= joint.upper + 1e-9);
  }
}

}  // namespace
}  // namespace tubeplan::deflection
