// Exact derivatives of the deflected tip pose: the direct change by a variable from dual numbers, and the arm's
// response from the linearisation of the converged shape.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

/// Variable of a derivative: a joint reading (index), the hung load, gravity rotated about a base axis (index: the
/// rotation vector that turns gravity_B, and a wrench with it, because both are fixed in the world), or a number of the
/// arm.
struct Variable {
  enum class Type { kJoint, kLoad, kGravityTurn, kParameter };
  Type type = Type::kJoint;
  int index = 0;
  ParameterPath parameter;

  static Variable joint(int index) { return {Type::kJoint, index, {}}; }
  static Variable load() { return {Type::kLoad, 0, {}}; }
  static Variable gravityTurn(int axis) { return {Type::kGravityTurn, axis, {}}; }
  static Variable number(const ParameterPath& path) { return {Type::kParameter, 0, path}; }
};

std::vector<Variable> jointVariables(const Arm& arm);

struct TipDerivatives {
  FlexibleKinematics kinematics;  ///< the shape itself
  Eigen::Matrix3Xd position_B;    ///< d p_BD / d variable [m per unit], one column per variable
  /// Rotation vector of the tool frame per unit of the variable [rad per unit], base axes.
  Eigen::Matrix3Xd rotation_B;
};

/// Returns the tip pose and its derivatives by each of `variables`. If the shape does not converge, `kinematics.status`
/// states it and the columns are NaN.
[[nodiscard]] TipDerivatives differentiateTip(const Arm& arm, const Posture& posture,
                                              const std::vector<Variable>& variables,
                                              const FlexibleKinematicsOptions& options = {});

/// Returns the same derivatives for the deflected frame of a row instead of the tool frame.
[[nodiscard]] TipDerivatives differentiateRow(const Arm& arm, int row, const Posture& posture,
                                              const std::vector<Variable>& variables,
                                              const FlexibleKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
