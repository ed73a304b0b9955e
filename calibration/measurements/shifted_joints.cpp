#include "calibration/measurements/shifted_joints.hpp"

#include <algorithm>

namespace tubeplan::calibration {

using Eigen::Index;

ShiftedJoints::ShiftedJoints(const deflection::Arm& arm, const PredictionRequest& request) : arm_(arm), bare_(arm) {
  bare_.effects.clear();
  const auto requested = variablesOf(request, arm);
  for (std::size_t k = 0; k < requested.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const auto& path = requested[k].parameter;
    if (requested[k].type != deflection::Variable::Type::kParameter || path.effect < 0) {
      variables_.push_back(requested[k]);
      columns_.push_back(column);
      continue;
    }
    deflection::Effect unit = arm.effects[static_cast<std::size_t>(path.effect)];
    std::ranges::fill(unit.values, 0);
    unit.values[static_cast<std::size_t>(path.value)] = 1;
    of_effects_.push_back({column, std::move(unit)});
  }
  if (of_effects_.empty()) return;
  for (const auto& joint : deflection::jointVariables(arm)) variables_.push_back(joint);
}

Eigen::VectorXd ShiftedJoints::valuesAt(const deflection::Posture& posture) const {
  deflection::JointShift shift(arm_, posture);
  Eigen::VectorXd q = posture.q;
  for (const auto& effect : arm_.effects) q += shift.by(effect);
  return q;
}

void ShiftedJoints::compose(const deflection::Posture& posture,
                            const Eigen::Matrix<double, 6, Eigen::Dynamic>& by_variables,
                            Eigen::Matrix<double, 6, Eigen::Dynamic>& by_requested) const {
  by_requested.resize(6, static_cast<Index>(columns_.size() + of_effects_.size()));
  for (std::size_t k = 0; k < columns_.size(); ++k)
    by_requested.col(columns_[k]) = by_variables.col(static_cast<Index>(k));
  deflection::JointShift shift(arm_, posture);
  for (const OfEffect& of : of_effects_)
    by_requested.col(of.column).noalias() = by_variables.rightCols(posture.q.size()).lazyProduct(shift.by(of.unit));
}

}  // namespace tubeplan::calibration
