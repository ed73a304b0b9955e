// Exact derivatives of the deflected tip pose: dual numbers give the derivatives of links, elements and loads, and the
// linearised shape gives the arm's response to their changes.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::deflection {

/// Variable of the derivatives of the tip: a joint reading (`index` of the joint), the hung load, a rotation of gravity
/// about a base axis (`index` of the axis), or a parameter of the arm. The rotation also turns the wrench, because
/// gravity and the wrench are both fixed in the world.
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
  FlexibleKinematics kinematics;  ///< the deflected shape
  Eigen::Matrix3Xd position_B;    ///< derivatives of the tip position p_BD [m per unit], one column per variable
  /// Derivatives of the tool frame's rotation, as rotation vectors in base axes [rad per unit], one column per
  /// variable.
  Eigen::Matrix3Xd rotation_B;
};

/// Returns the tip pose and its derivatives with respect to each of `variables`. If the shape does not converge,
/// `kinematics.status` gives the reason and the columns are NaN.
[[nodiscard]] TipDerivatives differentiateTip(const Arm& arm, const Posture& posture,
                                              const std::vector<Variable>& variables,
                                              const FlexibleKinematicsOptions& options = {});

/// Returns the pose and derivatives of a row's deflected frame instead of the tool frame; see differentiateTip().
[[nodiscard]] TipDerivatives differentiateRow(const Arm& arm, int row, const Posture& posture,
                                              const std::vector<Variable>& variables,
                                              const FlexibleKinematicsOptions& options = {});

}  // namespace tubeplan::deflection
