#include "deflection/tip_derivatives.hpp"

#include <algorithm>

#include "deflection/shape_tangent.hpp"

namespace tubeplan::deflection {

namespace {

void seed(Dual& x, int slot) { x.derivatives()[slot] = 1; }

/// An arm and posture in dual numbers, for a few variables at a time.
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
void differentiateSome(const ShapeTangent& tangent, Seeded& seeded, const Posture& posture,
                       const std::vector<Variable>& variables, int first, const FlexibleKinematicsOptions& options,
                       TipDerivatives& out) {
  seeded.posture = {posture.q.cast<Dual>(), Dual(posture.load),  posture.gravity_B.cast<Dual>(),
                    posture.senses,         posture.temperature, posture.time};
  Vector3<Dual> gravity_turn = Vector3<Dual>::Zero();
  const int count = std::min<int>(kDualSize, static_cast<int>(variables.size()) - first);
  for (int k = 0; k < count; ++k) seedVariable(seeded, gravity_turn, variables[first + k], k);
  seeded.posture.gravity_B += gravity_turn.cross(posture.gravity_B.cast<Dual>());
  const TipTangent columns = tangent.along(seeded.arm, seeded.posture, options);
  for (int k = 0; k < count; ++k)
    if (variables[first + k].type == Variable::Type::kParameter)
      locate(seeded.arm, variables[first + k].parameter).derivatives() = {};
  if (columns.status != KinematicsStatus::kConverged) return;
  out.position_B.middleCols(first, count) = columns.tip.position.leftCols(count);
  out.rotation_B.middleCols(first, count) = columns.tip.rotation.leftCols(count);
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
  const ShapeTangent tangent(arm, posture, out.kinematics);
  Seeded seeded{castArm<Dual>(arm), {}};
  for (int first = 0; first < n; first += kDualSize)
    differentiateSome(tangent, seeded, posture, variables, first, options, out);
  return out;
}

}  // namespace tubeplan::deflection
