// Central differences of the deflected tip, or of a row's deflected frame, for comparison with exact derivatives.
#pragma once

#include "deflection/tip_derivatives.hpp"
#include "deflection/tip_sensitivity.hpp"

namespace tubeplan::deflection {

inline const FlexibleKinematicsOptions kTight{1e-15, 200};

/// Changes one variable of the arm or posture by `h`.
inline void step(Arm& arm, Posture& posture, const Variable& variable, double h) {
  switch (variable.type) {
    case Variable::Type::kJoint:
      posture.q[variable.index] += h;
      break;
    case Variable::Type::kLoad:
      posture.load += h;
      break;
    case Variable::Type::kGravityTurn: {
      const Eigen::Matrix3d R = rotationFromVector<double>(h * Eigen::Vector3d::Unit(variable.index));
      posture.gravity_B = R * posture.gravity_B;
      if (posture.wrench) posture.wrench = Wrench{R * posture.wrench->force_B, R * posture.wrench->moment_B};
      break;
    }
    case Variable::Type::kParameter:
      locate(arm, variable.parameter) += h;
      break;
  }
}

inline PoseOf<double> frameAt(Arm arm, Posture posture, const Variable& variable, double h, int row) {
  step(arm, posture, variable, h);
  const auto shape = solveFlexibleKinematics(arm, posture, kTight);
  return row == kTool ? PoseOf<double>{shape.X_BD.R * shape.R_LT, shape.X_BD.p}
                      : shape.rows[static_cast<std::size_t>(row)].X_BL;
}

struct Difference {
  Eigen::Vector3d position, rotation;
};

/// Returns the fourth-order central difference with respect to one variable.
inline Difference centralDifference(const Arm& arm, const Posture& posture, const Variable& variable, double h,
                                    int row = kTool) {
  const auto slope = [&](double step_size) {
    const auto plus = frameAt(arm, posture, variable, step_size, row),
               minus = frameAt(arm, posture, variable, -step_size, row);
    const Eigen::Matrix3d turn = (plus.R - minus.R) * (plus.R + minus.R).inverse();
    Difference d{(plus.p - minus.p) / (2 * step_size), {}};
    d.rotation =
        Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) / (2 * step_size);
    return d;
  };
  const Difference one = slope(h), two = slope(2 * h);
  return {(4 * one.position - two.position) / 3, (4 * one.rotation - two.rotation) / 3};
}

}  // namespace tubeplan::deflection
