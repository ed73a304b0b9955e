#include "calibration/measurements/frame_motion.hpp"

#include "deflection/effects/effect.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Isometry3d, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d;

void FrameMotion::subtract(const FrameMotion& from, Index own_joints) {
  p_BF -= from.p_BF;
  const Index shared = by_BF.cols() - own_joints;
  by_BF.leftCols(shared) -= from.by_BF.leftCols(shared);
  if (own_joints == 0) return;
  by_BF.conservativeResize(Eigen::NoChange, shared + 2 * own_joints);
  by_BF.rightCols(own_joints) = -from.by_BF.rightCols(own_joints);
}

std::vector<deflection::Variable> variablesOf(const PredictionRequest& request, const deflection::Arm& arm) {
  std::vector<deflection::Variable> variables = request.numbers;
  if (request.by_base)
    for (int axis = 0; axis < 3; ++axis) variables.push_back(deflection::Variable::gravityTurn(axis));
  if (request.by_joints)
    for (int joint = 0; joint < arm.jointCount(); ++joint) variables.push_back(deflection::Variable::joint(joint));
  return variables;
}

Index ownJointsOf(const Measurement& measurement, const PredictionRequest& request, const deflection::Arm& arm) {
  return request.by_joints && referenceOf(measurement) ? arm.jointCount() : 0;
}

namespace {

bool isMeasurementScale(const deflection::Arm& arm, const deflection::Variable& variable) {
  if (variable.type != deflection::Variable::Type::kParameter || variable.parameter.effect < 0) return false;
  const auto& effect = arm.effects.at(static_cast<std::size_t>(variable.parameter.effect));
  return deflection::effectKinds().at(static_cast<std::size_t>(effect.kind)).stage ==
         deflection::EffectStage::kMeasurement;
}

/// Converts true lengths to measured lengths if the arm has a scale error of the measuring system. Rows that are angles
/// do not change, nor do touches of unknown points, which measure nothing in the world frame.
void scaleCoordinates(const deflection::Arm& arm, const Measurement& measurement, const PredictionRequest& request,
                      Prediction& prediction) {
  if (arm.effects.empty() || !kindOf(measurement).is_by_scale || touchesUnknownPoint(measurement)) return;
  const double scale = deflection::measurementScale(arm);
  const Index rows = prediction.value.size() - kindOf(measurement).turn_rows;
  for (std::size_t k = 0; k < request.numbers.size(); ++k) {
    auto column = prediction.by_numbers.col(static_cast<Index>(k)).head(rows);
    if (isMeasurementScale(arm, request.numbers[k]))
      column = prediction.value.head(rows);
    else if (scale != 1)
      column *= scale;
  }
  if (scale == 1) return;
  prediction.value.head(rows) *= scale;
  if (prediction.by_base.size()) prediction.by_base.topRows(rows) *= scale;
  if (prediction.by_joints.size()) prediction.by_joints.topRows(rows) *= scale;
}

}  // namespace

void deriveOf(const FrameMotion& frame, const MeasuredSlope& slope, const Isometry3d& X_WB,
              const PredictionRequest& request, bool is_displacement, Prediction& prediction) {
  const Matrix3d R = X_WB.linear();
  const MeasuredRows by_place = slope.by_place * R, by_turn = slope.by_turn * R;
  const auto seen = [&](Index first, Index count, auto& by) {
    by.noalias() = by_place.lazyProduct(frame.by_BF.block(0, first, 3, count));
    if (by_turn.size()) by.noalias() += by_turn.lazyProduct(frame.by_BF.block(3, first, 3, count));
  };
  auto next = static_cast<Index>(request.numbers.size());
  if (next) seen(0, next, prediction.by_numbers);
  if (request.by_base) {
    // A rotation of the base by w turns the arm by w, and gravity in the base frame by -w.
    MeasuredRows by_gravity;
    seen(next, 3, by_gravity);
    next += 3;
    prediction.by_base.setZero(by_place.rows(), 6);
    auto turned = prediction.by_base.rightCols<3>();
    turned.noalias() -= by_gravity.lazyProduct(R.transpose());
    turned.noalias() -= slope.by_place.lazyProduct(deflection::crossMatrix<double>(R * frame.p_BF));
    if (!is_displacement) prediction.by_base.leftCols<3>() = slope.by_place;
    if (!is_displacement && by_turn.size()) turned += slope.by_turn;
  }
  if (request.by_joints) seen(next, frame.by_BF.cols() - next, prediction.by_joints);
}

void predictOf(const FrameMotion& frame, const deflection::Arm& arm, const Isometry3d& X_WB,
               const Measurement& measurement, const PredictionRequest& request, Prediction& prediction) {
  const bool is_displacement = isDisplacement(measurement);
  ToolPose tool;
  tool.p_W = X_WB.linear() * frame.p_BF;
  if (!is_displacement) tool.p_W += X_WB.translation();
  if (seesTurn(measurement)) tool.R_WT = X_WB.linear() * frame.R_BF;
  prediction.value = predictedValue(measurement, tool);
  if (request.needsSlopes())
    deriveOf(frame, predictedSlope(measurement, tool), X_WB, request, is_displacement, prediction);
  scaleCoordinates(arm, measurement, request, prediction);
}

}  // namespace tubeplan::calibration
