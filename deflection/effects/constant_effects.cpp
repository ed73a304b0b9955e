#include "deflection/effects/constant_effects.hpp"

#include <algorithm>
#include <utility>

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

namespace {

constexpr double kSameShift = 1e-12;  // tolerance of a joint's shift at different readings [rad or m]

/// Returns the arm with only these effects, without those that act by weight or by set-up.
Arm withEffects(const Arm& arm, std::vector<Effect> effects) {
  Arm bare = arm;
  bare.side_chains.clear();
  bare.mountings.clear();
  bare.tip_load.reset();
  bare.effects = std::move(effects);
  return bare;
}

/// Returns the differences between the true joint values and the readings, where every joint reads `reading`.
Eigen::VectorXd shiftsAt(const Arm& arm, double reading) {
  Posture posture;
  posture.q.setConstant(arm.jointCount(), reading);
  return contextOf(arm, posture).posture.q - posture.q;
}

bool isConstant(const Arm& arm, const Effect& effect) {
  const EffectKind& kind = kindOf(effect);
  if (kind.varies_with != std::vector<EffectVariable>{EffectVariable::kJoint}) return false;
  if (kind.stage != EffectStage::kJointReading) return kind.stage == EffectStage::kGeometry;
  const Arm alone = withEffects(arm, {effect});
  const Eigen::VectorXd shift = shiftsAt(alone, 0);
  return std::ranges::all_of(std::vector{0.3, -0.7, 1.1}, [&](double reading) {
    return (shiftsAt(alone, reading) - shift).cwiseAbs().maxCoeff() <= kSameShift;
  });
}

}  // namespace

ArmByNumbers writeConstantEffects(const Arm& arm) {
  ArmByNumbers result{arm, {}};
  std::vector<Effect> constant;
  result.arm.effects.clear();
  for (const Effect& effect : arm.effects) {
    const bool is_constant = isConstant(arm, effect);
    (is_constant ? constant : result.arm.effects).push_back(effect);
    if (is_constant) result.written.push_back(textOf(arm, effect));
  }
  const Arm by_constant = withEffects(arm, std::move(constant));
  Posture posture;
  posture.q.setZero(arm.jointCount());
  const auto context = contextOf(by_constant, posture);
  result.arm.rows = context.arm.rows;
  result.arm.p_LT = context.arm.p_LT;
  result.arm.tool_turn_L = context.arm.tool_turn_L;
  Eigen::Index joint = 0;
  for (const int row : activeRows(arm))
    result.arm.rows[static_cast<std::size_t>(row)].joint.offset += context.posture.q[joint++];
  return result;
}

}  // namespace tubeplan::deflection
