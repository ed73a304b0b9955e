#include "calibration/reading_prediction.hpp"

#include <cassert>
#include <cmath>

#include "calibration/measurement_posture.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::calibration {

using deflection::Variable;
using Eigen::Matrix3d, Eigen::Matrix3Xd, Eigen::MatrixXd, Eigen::Vector3d;

namespace {

constexpr double kLeastSigma = 1e-6;  // m

Matrix3d crossMatrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

bool isMeasurementScale(const deflection::Arm& arm, const Variable& variable) {
  if (variable.type != Variable::Type::kParameter || variable.parameter.effect < 0) return false;
  const auto& effect = arm.effects.at(static_cast<std::size_t>(variable.parameter.effect));
  return deflection::effectKinds().at(static_cast<std::size_t>(effect.kind)).stage ==
         deflection::EffectStage::kMeasurement;
}

/// True coordinates to measured ones, where the arm carries an error of the measuring scale. Touches of unknown points
/// measure nothing in the world.
void scaleCoordinates(const deflection::Arm& arm, const PredictionRequest& request, Prediction& prediction) {
  const double scale = deflection::measurementScale(arm);
  for (std::size_t k = 0; k < request.numbers.size(); ++k)
    if (isMeasurementScale(arm, request.numbers[k]))
      prediction.by_numbers.col(static_cast<Eigen::Index>(k)) = prediction.value;
    else if (scale != 1)
      prediction.by_numbers.col(static_cast<Eigen::Index>(k)) *= scale;
  if (scale == 1) return;
  prediction.value *= scale;
  if (prediction.by_base.size()) prediction.by_base *= scale;
  if (prediction.by_joints.size()) prediction.by_joints *= scale;
}

void subtract(Prediction& a, const Prediction& b) {
  a.ok = a.ok && b.ok;
  a.value -= b.value;
  if (a.by_numbers.size()) a.by_numbers -= b.by_numbers;
  if (a.by_base.size()) a.by_base -= b.by_base;
  if (a.by_joints.size()) a.by_joints -= b.by_joints;
}

/// From the tip's place to what the reading's kind measures of it.
void measure(const Measurement& reading, Prediction& tip) {
  const MeasurementKindRow& kind = kindOf(reading);
  const Vector3d p_W = tip.value;
  tip.value = kind.value(reading, p_W);
  const MeasuredSlope slope = kind.slope(reading, p_W);
  if (tip.by_numbers.size()) tip.by_numbers = slope * tip.by_numbers;
  if (tip.by_base.size()) tip.by_base = slope * tip.by_base;
  if (tip.by_joints.size()) tip.by_joints = slope * tip.by_joints;
}

}  // namespace

deflection::Posture postureOf(const Measurement& reading, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
  return postureOf(reading, deflection::gravityInBase(arm, X_WB));
}

ReadingPredictor::ReadingPredictor(const deflection::Arm& arm)
    : arm_(arm), tip_(std::make_unique<deflection::TipDifferentiation>(arm)) {}

ReadingPredictor::~ReadingPredictor() = default;

Prediction ReadingPredictor::predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                        const PredictionRequest& request) {
  std::vector<Variable> variables = request.numbers;
  const auto numbers = static_cast<Eigen::Index>(variables.size());
  if (request.by_base)
    for (int axis = 0; axis < 3; ++axis) variables.push_back(Variable::gravityTurn(axis));
  if (request.by_joints)
    for (int joint = 0; joint < posture.q.size(); ++joint) variables.push_back(Variable::joint(joint));
  Prediction tip;
  const Matrix3d R = X_WB.linear();
  tip.ok = tip_->solve(posture, variables) == deflection::KinematicsStatus::kConverged;
  const Vector3d r_W = R * tip_->arm().X_BD().p;
  tip.value = X_WB.translation() + r_W;
  if (variables.empty()) return tip;
  const auto by = tip_->columns().topRows<3>();
  tip.by_numbers = R * by.leftCols(numbers);
  if (request.by_base) {
    tip.by_base.resize(3, 6);
    tip.by_base.leftCols<3>().setIdentity();
    // Turning the base by w turns the arm by w, and gravity, seen from the base, by -w.
    tip.by_base.rightCols<3>() = -crossMatrix(r_W) - R * by.middleCols<3>(numbers) * R.transpose();
  }
  if (request.by_joints) tip.by_joints = R * by.rightCols(posture.q.size());
  return tip;
}

Prediction predictReading(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& reading,
                          const PredictionRequest& request) {
  return ReadingPredictor(arm).predict(X_WB, reading, request);
}

Prediction ReadingPredictor::predict(const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                     const PredictionRequest& request) {
  deflection::Posture posture = postureOf(reading, arm_, X_WB);
  Prediction prediction = predictTip(X_WB, posture, request);
  if (kindOf(reading).is_displacement) {
    posture.load = 0;
    subtract(prediction, predictTip(X_WB, posture, request));
  }
  measure(reading, prediction);
  if (reading.p_W) scaleCoordinates(arm_, request, prediction);
  return prediction;
}

Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                      double load) {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  return ReadingPredictor(arm).predictTip(X_WB, {q, load, deflection::gravityInBase(arm, X_WB)}, request);
}

MatrixXd encoderCovariance(const deflection::Arm& arm, const MatrixXd& by_joints) {
  MatrixXd covariance = MatrixXd::Zero(by_joints.rows(), by_joints.rows());
  const auto active = deflection::activeRows(arm);
  assert(by_joints.cols() == static_cast<Eigen::Index>(active.size()));
  for (std::size_t k = 0; k < active.size(); ++k) {
    const Eigen::VectorXd column =
        by_joints.col(static_cast<Eigen::Index>(k)) * arm.rows[static_cast<std::size_t>(active[k])].joint.encoder_sigma;
    covariance += column * column.transpose();
  }
  return covariance;
}

Matrix3d tipCovariance(const deflection::Arm& arm, const Prediction& tip,
                       const Eigen::Matrix<double, 6, 6>& base_covariance) {
  return tip.by_base * base_covariance * tip.by_base.transpose() + encoderCovariance(arm, tip.by_joints);
}

MatrixXd readingCovariance(const deflection::Arm& arm, const Measurement& reading, const MatrixXd& by_joints) {
  const Eigen::Index rows = rowsOf(reading);
  const double sigma = std::isfinite(reading.sigma) ? std::max(reading.sigma, kLeastSigma) : kLeastSigma;
  return MatrixXd::Identity(rows, rows) * sigma * sigma + encoderCovariance(arm, by_joints);
}

}  // namespace tubeplan::calibration
