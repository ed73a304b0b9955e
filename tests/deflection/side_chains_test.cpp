// Side chains, links that branch off a row and do not lead to the tip, must load the arm with their weights.
#include "deflection/side_chains.hpp"

#include <gtest/gtest.h>

#include "deflection/tip_derivatives.hpp"
#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns the Cobra with a side chain of two revolute joints and a prismatic joint on its third row.
Arm cobraWithSideChain() {
  Arm arm = cobraArm();
  SideChain<double> chain{2, {}};
  chain.rows.resize(3);
  chain.rows[0].name = "left-shoulder";
  chain.rows[0].placement = Origin<double>{{0.1, 0.2, -0.05}, {0.3, -0.2, 0.5}};
  chain.rows[0].joint.name = "left1";
  chain.rows[0].joint.type = JointType::kRevolute;
  chain.rows[0].weight.distributed = 60;
  chain.rows[1].name = "left-elbow";
  chain.rows[1].placement = DenavitHartenberg<double>{1.2, 0.4, 0.1, 0};
  chain.rows[1].joint.name = "left2";
  chain.rows[1].joint.type = JointType::kRevolute;
  chain.rows[1].weight.lumps = {{35, {0.2, -0.1, 0.05}}};
  chain.rows[2].name = "left-slide";
  chain.rows[2].placement = DenavitHartenberg<double>{-0.7, 0.3, 0, 0};
  chain.rows[2].joint.name = "left3";
  chain.rows[2].joint.type = JointType::kPrismatic;
  chain.rows[2].joint.lower = 0;
  chain.rows[2].joint.upper = 0.5;
  chain.rows[2].weight.end = 25;
  arm.side_chains = {chain};
  return arm;
}

Eigen::VectorXd anySidePosture() { return Eigen::Vector3d(0.4, -1.1, 0.2); }

TEST(SideChains, WeighWhatTheirLinksWeighWhereTheyAre) {
  // The expected sum comes from the side chain's rows solved as an arm of their own, weight by weight.
  const Arm arm = cobraWithSideChain();
  const SideChain<double>& chain = arm.side_chains[0];
  const Eigen::VectorXd q = anySidePosture();
  double weight = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Arm alone;
  alone.rows = chain.rows;
  alone.p_LT.setZero();
  const auto shape = solveFlexibleKinematics(alone, {q, 0});
  const auto at = [&](int row, const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return shape.rows[static_cast<std::size_t>(row)].X_BL.p + shape.rows[static_cast<std::size_t>(row)].X_BL.R * p;
  };
  const auto attach = [&](double size, const Eigen::Vector3d& p) {
    weight += size;
    moment += size * p;
  };
  const Eigen::Vector3d elbow = at(1, {0, 0, 0}), shoulder = at(0, {0, 0, 0});
  attach(60 * (elbow - shoulder).norm(), (elbow + shoulder) / 2);
  attach(35, at(1, {0.2, -0.1, 0.05}));
  attach(25, at(2, {0, 0, 0}));
  Eigen::Index joint = 0;
  const auto lump = weightOfSideChain<double>(chain, q, joint);
  EXPECT_EQ(joint, 3);
  EXPECT_NEAR(lump.weight, weight, 1e-12);
  EXPECT_LE((lump.at - moment / weight).norm(), 1e-12);
}

TEST(SideChains, BendTheArmAsALumpAtTheirCentreOfGravity) {
  std::mt19937_64 random(41);
  const Arm arm = cobraWithSideChain();
  for (int n = 0; n < 20; ++n) {
    Posture posture{randomJoints(arm, random), 80, randomDirection(random)};
    posture.side_q = anySidePosture() * (n % 5);
    Eigen::Index joint = 0;
    Arm lumped = cobraArm();
    // `carrier` holds the side chain's weight as a lump, in the axes of the row that carries the chain.
    Row<double> carrier;
    carrier.name = "carrier";
    carrier.placement = Origin<double>{};
    carrier.weight.lumps = {weightOfSideChain<double>(arm.side_chains[0], posture.side_q, joint)};
    Row<double> moved = lumped.rows[2];
    carrier.joint = moved.joint;
    moved.joint = {};
    const auto with = solveFlexibleKinematics(arm, posture, kTight);
    ASSERT_EQ(with.status, KinematicsStatus::kConverged);
    const auto without = solveFlexibleKinematics(lumped, posture, kTight);
    const double difference = (with.rows[2].moment_B - without.rows[2].moment_B).norm();
    EXPECT_GT(difference, 0.1) << "the side chain is felt";
    // In equilibrium, the moment on the row must be the moment on the next row plus that of the weights in between.
    const auto& row = with.rows[2];
    const Eigen::Vector3d at_B = row.X_BL.R * carrier.weight.lumps[0].at;
    Eigen::Vector3d beyond = Eigen::Vector3d::Zero();
    const auto& next = with.rows[3];
    beyond = next.moment_B + (next.X_BL.p - row.X_BL.p).cross(next.force_B);
    Eigen::Vector3d own = Eigen::Vector3d::Zero();
    for (const auto& lump : arm.rows[2].weight.lumps)
      own += (row.X_BL.R * lump.at).cross(lump.weight * posture.gravity_B);
    const Eigen::Vector3d member = next.X_BL.p - row.X_BL.p;
    own += (member / 2).cross(arm.rows[2].weight.distributed * undeflectedMember(arm, 2).norm() * posture.gravity_B);
    own += member.cross(arm.rows[2].weight.end * posture.gravity_B);
    const Eigen::Vector3d attached_moment = at_B.cross(carrier.weight.lumps[0].weight * posture.gravity_B);
    EXPECT_LE((row.moment_B - beyond - own - attached_moment).norm(), 1e-3 * row.moment_B.norm());
  }
}

TEST(SideChains, DerivativesByTheirNumbersAreDifferences) {
  std::mt19937_64 random(42);
  const Arm arm = cobraWithSideChain();
  std::vector<Variable> variables = jointVariables(arm);
  std::vector<std::string> names{"1", "2", "3", "4"};
  for (const auto& p : parametersOf(arm))
    if (p.path.side_chain >= 0) variables.push_back(Variable::number(p.path)), names.push_back(p.name);
  ASSERT_EQ(names.size(), 4 + 26u);
  for (int n = 0; n < 10; ++n) {
    Posture posture{randomJoints(arm, random), 80, randomDirection(random)};
    posture.side_q = anySidePosture() * (n % 3);
    const auto exact = differentiateTip(arm, posture, variables, kTight);
    ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged);
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const bool weighs = names[k].find("weight") != std::string::npos;
      const double h = weighs ? 5 : 1e-3;
      const Difference d = centralDifference(arm, posture, variables[k], h);
      const double off = (d.position - exact.position_B.col(static_cast<Eigen::Index>(k))).norm() +
                         (d.rotation - exact.rotation_B.col(static_cast<Eigen::Index>(k))).norm();
      EXPECT_LE(off, 1e-6 * (d.position.norm() + d.rotation.norm()) + 1e-12 / h) << names[k];
    }
  }
}

TEST(SideChains, ProblemsAreFound) {
  const auto problemsOf = [](auto&& change) {
    Arm arm = cobraWithSideChain();
    change(arm.side_chains[0]);
    return findProblems(arm).size();
  };
  EXPECT_EQ(problemsOf([](auto&) {}), 0u);
  EXPECT_EQ(problemsOf([](auto& b) { b.rows[1].joint_stiffness[2] = 100; }), 1u);
  EXPECT_EQ(problemsOf([](auto& b) { b.rows[1].name = "tool"; }), 1u);
  EXPECT_EQ(problemsOf([](auto& b) { b.rows[1].joint.name = "theta1"; }), 1u);
  EXPECT_EQ(problemsOf([](auto& b) { b.rows[1].weight.lumps[0].weight = std::nan(""); }), 1u);
  EXPECT_EQ(problemsOf([](auto& b) {
              for (auto& row : b.rows) row.weight = {};
            }),
            1u);
}

}  // namespace
}  // namespace tubeplan::deflection
