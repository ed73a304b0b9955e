#include "calibration/measurements/reading_prediction.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include "deflection/effects/effect.hpp"
#include "deflection/rotation.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::MatrixXd, Eigen::Vector3d;

namespace {

bool isMeasurementScale(const deflection::Arm& arm, const deflection::Variable& variable) {
  if (variable.type != deflection::Variable::Type::kParameter || variable.parameter.effect < 0) return false;
  const auto& effect = arm.effects.at(static_cast<std::size_t>(variable.parameter.effect));
  return deflection::effectKinds().at(static_cast<std::size_t>(effect.kind)).stage ==
         deflection::EffectStage::kMeasurement;
}

/// True lengths to measured ones, where the arm carries an error of the measuring scale: the first rows, all but turns.
/// Touches of unknown points measure nothing in the world.
void scaleCoordinates(const deflection::Arm& arm, const Measurement& reading, const PredictionRequest& request,
                      Prediction& prediction) {
  const double scale = deflection::measurementScale(arm);
  const Eigen::Index rows = prediction.value.size() - kindOf(reading).turn_rows;
  if (!kindOf(reading).is_by_scale) return;
  for (std::size_t k = 0; k < request.numbers.size(); ++k) {
    auto column = prediction.by_numbers.col(static_cast<Eigen::Index>(k)).head(rows);
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

/// The pose of the tool, or of a row's frame, with its derivatives, 6 rows: its place [m], then the turn [rad] about
/// the world's axes.
struct ToolPrediction {
  bool ok = false;
  ToolPose pose;
  Eigen::MatrixXd by_numbers, by_base, by_joints;
};

ToolPrediction predictTool(deflection::TipDifferentiation& tip, const Eigen::Isometry3d& X_WB,
                           const deflection::Posture& posture, const PredictionRequest& request,
                           const std::optional<int>& row = {}) {
  std::vector<deflection::Variable> variables = request.numbers;
  const auto numbers = static_cast<Eigen::Index>(variables.size());
  if (request.by_base)
    for (int axis = 0; axis < 3; ++axis) variables.push_back(deflection::Variable::gravityTurn(axis));
  if (request.by_joints)
    for (int joint = 0; joint < posture.q.size(); ++joint) variables.push_back(deflection::Variable::joint(joint));
  ToolPrediction tool;
  const Matrix3d R = X_WB.linear();
  tool.ok = (row ? tip.solveRow(*row, posture, variables) : tip.solve(posture, variables)) ==
            deflection::KinematicsStatus::kConverged;
  const auto X_BF = row ? tip.arm().X_BL(*row) : tip.arm().X_BD();
  const Vector3d r_W = R * X_BF.p;
  tool.pose = {X_WB.translation() + r_W, R * X_BF.R};
  if (variables.empty()) return tool;
  MatrixXd by(6, tip.columns().cols());
  by << R * tip.columns().topRows<3>(), R * tip.columns().bottomRows<3>();
  tool.by_numbers = by.leftCols(numbers);
  if (request.by_base) {
    tool.by_base = MatrixXd::Identity(6, 6);
    // Turning the base by w turns the arm by w, and gravity, seen from the base, by -w.
    tool.by_base.rightCols<3>() -= by.middleCols<3>(numbers) * R.transpose();
    tool.by_base.topRightCorner<3, 3>() -= deflection::crossMatrix<double>(r_W);
  }
  if (request.by_joints) tool.by_joints = by.rightCols(posture.q.size());
  return tool;
}

/// From the tool to what is measured of it; of a displacement to how far the tip is from where it rests unloaded.
Prediction measured(const Measurement& reading, const ToolPrediction& tool) {
  const MeasuredSlope slope = predictedSlope(reading, tool.pose);
  const auto seen = [&](const MatrixXd& by) -> MatrixXd {
    if (by.size() == 0) return {};
    MatrixXd rows = slope.by_place * by.topRows<3>();
    if (slope.by_turn.size()) rows += slope.by_turn * by.bottomRows<3>();
    return rows;
  };
  return {tool.ok, predictedValue(reading, tool.pose), seen(tool.by_numbers), seen(tool.by_base), seen(tool.by_joints)};
}

/// `shares_joints` where both stand at the same joint readings, and so share the encoders' noise.
void subtract(ToolPrediction& a, const ToolPrediction& b, bool shares_joints) {
  a.ok = a.ok && b.ok;
  a.pose.p_W -= b.pose.p_W;
  if (a.by_numbers.size()) a.by_numbers -= b.by_numbers;
  if (a.by_base.size()) a.by_base -= b.by_base;
  if (!a.by_joints.size()) return;
  if (shares_joints) {
    a.by_joints -= b.by_joints;
    return;
  }
  MatrixXd both(6, 2 * a.by_joints.cols());
  both << a.by_joints, -b.by_joints;
  a.by_joints = std::move(both);
}

/// Of the tool, or of a row's frame.
std::optional<ToolPose> poseAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& reading,
                               const std::optional<int>& row, const deflection::FlexibleKinematicsOptions& options) {
  const auto shape = deflection::solveFlexibleKinematics(arm, postureOf(reading, arm, X_WB), options);
  if (shape.status != deflection::KinematicsStatus::kConverged) return std::nullopt;
  const auto& X_BF = row ? shape.rows.at(static_cast<std::size_t>(*row)).X_BL : shape.X_BD;
  return ToolPose{X_WB * X_BF.p,
                  row ? Matrix3d(X_WB.linear() * X_BF.R) : Matrix3d(X_WB.linear() * X_BF.R * shape.R_LT)};
}

}  // namespace

ReadingPredictor::ReadingPredictor(const deflection::Arm& arm)
    : arm_(arm), tip_(std::make_unique<deflection::TipDifferentiation>(arm)) {}

ReadingPredictor::~ReadingPredictor() = default;

Prediction ReadingPredictor::predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                        const PredictionRequest& request) {
  const ToolPrediction tool = predictTool(*tip_, X_WB, posture, request);
  const auto placeOf = [](const MatrixXd& by) -> MatrixXd {
    return by.size() ? MatrixXd(by.topRows<3>()) : MatrixXd();
  };
  return {tool.ok, tool.pose.p_W, placeOf(tool.by_numbers), placeOf(tool.by_base), placeOf(tool.by_joints)};
}

Prediction predictReading(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& reading,
                          const PredictionRequest& request) {
  return ReadingPredictor(arm).predict(X_WB, reading, request);
}

Prediction ReadingPredictor::predict(const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                     const PredictionRequest& request) {
  ToolPrediction tool = predictTool(*tip_, X_WB, postureOf(reading, arm_, X_WB), request, reading.row);
  if (!reading.row) tool.pose.R_WT *= toolFrame(tip_->arm().effective());
  if (const auto from = referencePostureOf(reading, arm_, X_WB))
    subtract(tool, predictTool(*tip_, X_WB, *from, request), !referenceOf(reading));
  Prediction prediction = measured(reading, tool);
  if (!touchesUnknownPoint(reading)) scaleCoordinates(arm_, reading, request, prediction);
  return prediction;
}

Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                      double load) {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  return ReadingPredictor(arm).predictTip(X_WB, {q, load, deflection::gravityInBase(arm, X_WB)}, request);
}

std::optional<ToolPose> toolAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& reading,
                               const deflection::FlexibleKinematicsOptions& options) {
  return poseAt(arm, X_WB, reading, std::nullopt, options);
}

std::optional<ToolPose> frameAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                const deflection::FlexibleKinematicsOptions& options) {
  return poseAt(arm, X_WB, reading, reading.row, options);
}

MatrixXd encoderCovariance(const deflection::Arm& arm, const MatrixXd& by_joints) {
  MatrixXd covariance = MatrixXd::Zero(by_joints.rows(), by_joints.rows());
  const auto joints = arm.jointCount();
  assert(by_joints.cols() % joints == 0);
  for (Eigen::Index k = 0; k < by_joints.cols(); ++k) {
    const Eigen::VectorXd column = by_joints.col(k) * arm.joint(k % joints).encoder_sigma;
    covariance += column * column.transpose();
  }
  return covariance;
}

Matrix3d tipCovariance(const deflection::Arm& arm, const Prediction& tip,
                       const Eigen::Matrix<double, 6, 6>& base_covariance) {
  return tip.by_base * base_covariance * tip.by_base.transpose() + encoderCovariance(arm, tip.by_joints);
}

MatrixXd readingCovariance(const deflection::Arm& arm, const Measurement& reading, const MatrixXd& by_joints) {
  return encoderCovariance(arm, by_joints) + statedCovariance(reading);
}

}  // namespace tubeplan::calibration
