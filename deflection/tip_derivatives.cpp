#include "deflection/tip_derivatives.hpp"

#include <algorithm>
#include <cassert>

namespace tubeplan::deflection {

namespace {

void seed(Dual& x, int slot) { x.derivatives()[slot] = 1; }

struct Seeded {
  ArmOf<Dual> arm;
  PostureOf<Dual> posture;
};

void seedVariable(Seeded& seeded, Vector3<Dual>& gravity_turn, const Variable& variable, int slot) {
  switch (variable.type) {
    case Variable::Type::kJoint:
      return seed(seeded.posture.q[variable.index], slot);
    case Variable::Type::kLoad:
      return seed(seeded.posture.load, slot);
    case Variable::Type::kGravityTurn:
      return seed(gravity_turn[variable.index], slot);
    case Variable::Type::kParameter:
      return seed(locate(seeded.arm, variable.parameter), slot);
  }
}

/// Columns of one pass: at most kDualSize variables from `first` on.
void differentiateSome(const ArmOf<Dual>& arm, const Posture& posture, const std::vector<Variable>& variables,
                       int first, const FlexibleKinematicsOptions& options, TipDerivatives& out) {
  Seeded seeded{arm,
                {posture.q.cast<Dual>(), Dual(posture.load), posture.gravity_B.cast<Dual>(), posture.senses,
                 posture.temperature, posture.time}};
  Vector3<Dual> gravity_turn = Vector3<Dual>::Zero();
  const int count = std::min<int>(kDualSize, static_cast<int>(variables.size()) - first);
  for (int k = 0; k < count; ++k) seedVariable(seeded, gravity_turn, variables[first + k], k);
  seeded.posture.gravity_B += gravity_turn.cross(posture.gravity_B.cast<Dual>());
  const auto dual = solveFlexibleKinematics(seeded.arm, seeded.posture, out.kinematics, options);
  if (dual.status != KinematicsStatus::kConverged) return;
  for (int k = 0; k < count; ++k) {
    Eigen::Matrix3d dR;
    for (int i = 0; i < 3; ++i) {
      out.position_B(i, first + k) = dual.X_BD.p[i].derivatives()[k];
      for (int j = 0; j < 3; ++j) dR(i, j) = dual.X_BD.R(i, j).derivatives()[k];
    }
    const Eigen::Matrix3d spin = dR * out.kinematics.X_BD.R.transpose();
    out.rotation_B.col(first + k) << (spin(2, 1) - spin(1, 2)) / 2, (spin(0, 2) - spin(2, 0)) / 2,
        (spin(1, 0) - spin(0, 1)) / 2;
  }
}

}  // namespace

std::vector<Variable> jointVariables(const Arm& arm) {
  std::vector<Variable> variables;
  for (int k = 0; k < static_cast<int>(activeRows(arm).size()); ++k) variables.push_back(Variable::joint(k));
  return variables;
}

TipDerivatives differentiateTip(const Arm& arm, const Posture& posture, const std::vector<Variable>& variables,
                                const FlexibleKinematicsOptions& options) {
  TipDerivatives out;
  out.kinematics = solveFlexibleKinematics(arm, posture, options);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const int n = static_cast<int>(variables.size());
  out.position_B = Eigen::Matrix3Xd::Constant(3, n, nan);
  out.rotation_B = Eigen::Matrix3Xd::Constant(3, n, nan);
  if (out.kinematics.status != KinematicsStatus::kConverged) return out;
  const ArmOf<Dual> dual_arm = castArm<Dual>(arm);
  for (int first = 0; first < n; first += kDualSize)
    differentiateSome(dual_arm, posture, variables, first, options, out);
  return out;
}

}  // namespace tubeplan::deflection
