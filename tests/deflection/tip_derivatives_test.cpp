// Exact derivatives of the tip against central differences, by joints, load, gravity and every number of the arm.
#include "deflection/tip_derivatives.hpp"

#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

struct Case {
  std::string name;
  Variable variable;
  double h;
};

std::vector<Case> casesOf(const Arm& arm) {
  std::vector<Case> cases{{"load", Variable::load(), 10}};
  for (int k = 0; k < 4; ++k) cases.push_back({"joint " + std::to_string(k), Variable::joint(k), 1e-3});
  for (int k = 0; k < 3; ++k) cases.push_back({"gravity " + std::to_string(k), Variable::gravityTurn(k), 1e-3});
  for (const auto& p : parametersOf(arm)) {
    const bool big = p.quantity == Quantity::kTorquePerAngle || p.quantity == Quantity::kPressure ||
                     p.quantity == Quantity::kLengthToTheFourth;
    const bool weight = p.quantity == Quantity::kForce || p.quantity == Quantity::kForcePerLength;
    cases.push_back({p.name, Variable::number(p.path), big ? 1e-3 * p.value : weight ? 5. : 1e-3});
  }
  return cases;
}

TEST(TipDerivatives, AgreeWithCentralDifferencesOverAThousandPostures) {
  const Arm arm = cobraArm();
  const auto cases = casesOf(arm);
  std::vector<Variable> variables;
  for (const auto& c : cases) variables.push_back(c.variable);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> load(0, 180);
  const double reach = reachOf(arm);
  for (int n = 0; n < 1000; ++n) {
    const Posture posture{randomJoints(arm, random), load(random), randomDirection(random)};
    const auto exact = differentiateTip(arm, posture, variables, kTight);
    ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged);
    // Every variable over the run, a few per posture.
    for (std::size_t k = static_cast<std::size_t>(n) % 7; k < cases.size(); k += 7) {
      const auto column = static_cast<Eigen::Index>(k);
      const Difference d = centralDifference(arm, posture, cases[k].variable, cases[k].h);
      const double size = d.position.norm() + reach * d.rotation.norm();
      const double off = (d.position - exact.position_B.col(column)).norm() +
                         reach * (d.rotation - exact.rotation_B.col(column)).norm();
      const double rounding = 1e-13 * reach / cases[k].h;
      ASSERT_LE(off, 1e-6 * size + rounding) << cases[k].name << " in posture " << n;
    }
  }
}

TEST(TipDerivatives, RigidAxesAreNotParameters) {
  for (const auto& p : parametersOf(cobraArm())) EXPECT_TRUE(std::isfinite(p.value)) << p.name;
  EXPECT_TRUE(findParameter(cobraArm(), "tool.joint_stiffness.z"));
  EXPECT_FALSE(findParameter(cobraArm(), "tool.joint_stiffness.x"));
  EXPECT_TRUE(findParameter(cobraArm(), "forearm.dh.a"));
  EXPECT_TRUE(findParameter(cobraArm(), "tool.tip.z"));
}

}  // namespace
}  // namespace tubeplan::deflection
