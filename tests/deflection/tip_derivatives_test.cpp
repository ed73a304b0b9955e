// Exact derivatives of the tip must agree with central differences, for joints, load, gravity and every parameter of
// the arm.
#include "deflection/tip_derivatives.hpp"

#include <gtest/gtest.h>

#include "tests/deflection/central_difference.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

struct VariableCase {
  std::string name;
  Variable variable;
  double h;
};

std::vector<VariableCase> casesOf(const Arm& arm) {
  std::vector<VariableCase> cases{{"load", Variable::load(), 10}};
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
    // Each posture tests a seventh of the variables; over all postures, every variable is tested.
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

// The derivatives of every row's frame must also be exact with respect to rows beyond it, which move it only through
// their loads.
TEST(TipDerivatives, OfEveryRowsFrameAgreeWithCentralDifferences) {
  const Arm arm = cobraArm(2);
  const auto cases = casesOf(arm);
  std::vector<Variable> variables;
  for (const auto& c : cases) variables.push_back(c.variable);
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> load(0, 180);
  const double reach = reachOf(arm);
  for (int n = 0; n < 60; ++n) {
    const Posture posture{randomJoints(arm, random), load(random), randomDirection(random)};
    for (int row = 0; row < static_cast<int>(arm.rows.size()); ++row) {
      const auto exact = differentiateRow(arm, row, posture, variables, kTight);
      ASSERT_EQ(exact.kinematics.status, KinematicsStatus::kConverged);
      for (std::size_t k = 0; k < cases.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        const Difference d = centralDifference(arm, posture, cases[k].variable, cases[k].h, row);
        const double size = d.position.norm() + reach * d.rotation.norm();
        const double off = (d.position - exact.position_B.col(column)).norm() +
                           reach * (d.rotation - exact.rotation_B.col(column)).norm();
        ASSERT_LE(off, 1e-6 * size + 1e-13 * reach / cases[k].h) << cases[k].name << " of row " << row;
      }
    }
  }
}

TEST(TipDerivatives, TheLoadBendsWhatIsBeforeARowAndTheTipBeyondTurnsItByThat) {
  const Arm arm = cobraArm();
  const Posture posture{Eigen::Vector4d(0.3, 1.1, -0.6, -0.2), 120, -Eigen::Vector3d::UnitZ()};
  const int last = static_cast<int>(arm.rows.size()) - 1;
  const auto frame = differentiateRow(arm, last, posture, {Variable::load(), Variable::joint(3)}, kTight);
  const auto tip = differentiateTip(arm, posture, {Variable::load(), Variable::joint(3)}, kTight);
  EXPECT_GT(frame.rotation_B.col(0).norm(), 1e-6) << "rad per N";
  EXPECT_NEAR(frame.rotation_B.col(1).norm(), 1, 0.05) << "its own joint turns it";
  EXPECT_LT(frame.position_B.col(1).norm(), 0.1 * tip.position_B.col(1).norm()) << "about its own origin";
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
