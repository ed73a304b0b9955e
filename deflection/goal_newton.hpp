// One goal met by damped steps, for whatever arm: where no kernel takes several at once. Internal to the inverse.
#pragma once

#include "deflection/inverse_kinematics.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

/// Residual of the goal and its Jacobian by the joints.
struct GoalResidual {
  Eigen::VectorXd value;
  Eigen::MatrixXd jacobian;
  double position_error = 0, tilt = 0, pitch = 0;
};

/// The residual of one goal after the other: a turret arm meets place and pitch exactly, others come as near as they
/// can.
class GoalProblem {
 public:
  GoalProblem(const Arm& arm, bool turret, double load, const Eigen::Vector3d& gravity_B,
              const InverseKinematicsOptions& options)
      : arm_(arm),
        load_(load),
        gravity_B_(gravity_B),
        options_(options),
        turret_(turret),
        reach_(reachOf(arm)),
        variables_(jointVariables(arm)),
        tip_(arm) {}

  bool exact() const { return turret_; }
  double reach() const { return reach_; }

  GoalResidual evaluate(const ToolGoal& goal, const Eigen::VectorXd& q);

 private:
  const Arm& arm_;
  double load_;
  Eigen::Vector3d gravity_B_;
  const InverseKinematicsOptions& options_;
  bool turret_;
  double reach_;
  std::vector<Variable> variables_;
  TipDifferentiation tip_;
};

/// Newton where square, Gauss-Newton otherwise; halved until the residual falls.
[[nodiscard]] Branch dampedNewton(GoalProblem& problem, const ToolGoal& goal, Eigen::VectorXd q,
                                  const InverseKinematicsOptions& options);

}  // namespace tubeplan::deflection
