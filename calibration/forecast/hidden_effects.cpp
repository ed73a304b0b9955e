#include "calibration/forecast/hidden_effects.hpp"

#include <algorithm>

#include "deflection/effects/effect.hpp"
#include "deflection/prepared_arm.hpp"

namespace tubeplan::calibration {

using Eigen::Vector3d;

namespace {

constexpr double kStiffnessShare = 0.1;  // that a stiffness may well be off by

bool canHide(const deflection::EffectKind& kind) {
  using deflection::EffectStage;
  if (kind.at == deflection::PlaceRule::kSetup) return false;
  const bool is_recorded = !kind.needs.time && !kind.needs.temperature && !kind.needs.approach_directions;
  return is_recorded && kind.places && kind.stage != EffectStage::kBase && kind.stage != EffectStage::kMeasurement;
}

bool hasEffect(const deflection::Arm& arm, int kind, const deflection::Place& place) {
  return std::any_of(arm.effects.begin(), arm.effects.end(),
                     [&](const deflection::Effect& effect) { return effect.kind == kind && effect.place == place; });
}

}  // namespace

struct HiddenEffects::Changed {
  Changed(deflection::Arm given, double scale) : arm(std::move(given)), to_plausible(scale), shapes(arm) {}

  deflection::Arm arm;
  double to_plausible;  ///< from what the change does to what its plausible size does
  deflection::PreparedArm shapes;
};

HiddenEffects::~HiddenEffects() = default;

void HiddenEffects::add(deflection::Arm changed, int kind, double share) {
  arms_.push_back(std::make_unique<Changed>(std::move(changed), 1 / share));
  kinds_.push_back(kind);
}

HiddenEffects::HiddenEffects(const deflection::Arm& arm, double share) {
  arms_.push_back(std::make_unique<Changed>(arm, 1));
  const auto& table = deflection::effectKinds();
  for (int kind = 0; kind < static_cast<int>(table.size()); ++kind) {
    const auto& row = table[static_cast<std::size_t>(kind)];
    if (!canHide(row)) continue;
    for (const auto& place : row.places(arm)) {
      if (hasEffect(arm, kind, place)) continue;
      deflection::Effect effect{kind, place, {}};
      for (const auto& number : row.parameters) effect.values.push_back(number.neutral);
      for (std::size_t v = 0; v < row.parameters.size(); ++v) {
        if (row.parameters[v].is_shape) continue;
        deflection::Arm changed = arm;
        changed.effects.push_back(effect);
        changed.effects.back().values[v] += share * row.parameters[v].plausible;
        add(std::move(changed), kind, share);
      }
    }
  }
  for (const auto& parameter : deflection::parametersOf(arm)) {
    if (!deflection::isStiffness(parameter.quantity) || parameter.path.effect >= 0) continue;
    deflection::Arm changed = arm;
    deflection::locate(changed, parameter.path) *= 1 + share * kStiffnessShare;
    add(std::move(changed), static_cast<int>(table.size()), share);
  }
}

Eigen::Matrix3Xd HiddenEffects::at(const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q, double load) {
  constexpr deflection::FlexibleKinematicsOptions kConvergedTightly{1e-12, 100};
  Eigen::Matrix3Xd columns = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(kinds_.size()));
  Vector3d tip = Vector3d::Zero();
  for (std::size_t k = 0; k < arms_.size(); ++k) {
    Changed& changed = *arms_[k];
    const deflection::Posture posture{q, load, deflection::gravityInBase(changed.arm, X_WB)};
    if (changed.shapes.solve(posture, kConvergedTightly) != deflection::KinematicsStatus::kConverged) {
      if (k == 0) return columns;
      continue;
    }
    const Vector3d found = X_WB * Vector3d(changed.shapes.X_BD().p);
    if (k == 0)
      tip = found;
    else if (found.allFinite())
      columns.col(static_cast<Eigen::Index>(k) - 1) = (found - tip) * changed.to_plausible;
  }
  return columns;
}

}  // namespace tubeplan::calibration
