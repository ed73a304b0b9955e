#include "deflection/tip_derivatives.hpp"

#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

std::vector<Variable> jointVariables(const Arm& arm) {
  std::vector<Variable> variables;
  for (int k = 0; k < arm.jointCount(); ++k) variables.push_back(Variable::joint(k));
  return variables;
}

TipDerivatives differentiateTip(const Arm& arm, const Posture& posture, const std::vector<Variable>& variables,
                                const FlexibleKinematicsOptions& options) {
  TipDifferentiation tip(arm);
  tip.solve(posture, variables, options);
  return {tip.arm().shape(), tip.columns().topRows<3>(), tip.columns().bottomRows<3>()};
}

TipDerivatives differentiateRow(const Arm& arm, int row, const Posture& posture, const std::vector<Variable>& variables,
                                const FlexibleKinematicsOptions& options) {
  TipDifferentiation frame(arm);
  frame.solveRow(row, posture, variables, options);
  return {frame.arm().shape(), frame.columns().topRows<3>(), frame.columns().bottomRows<3>()};
}

}  // namespace tubeplan::deflection
