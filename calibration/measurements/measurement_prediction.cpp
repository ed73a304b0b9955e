#include "calibration/measurements/measurement_prediction.hpp"

#include <cassert>

#include "calibration/measurements/frame_motion.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::MatrixXd;

namespace {

/// Computes the tool frame, or the frame of `row`, with its derivatives. Returns false if the shape does not converge.
bool solveFrame(deflection::TipDifferentiation& tip, const deflection::Posture& posture,
                const std::vector<deflection::Variable>& variables, const std::optional<int>& row, FrameMotion& frame) {
  const auto status = row ? tip.solveRow(*row, posture, variables) : tip.solve(posture, variables);
  const auto X_BF = row ? tip.arm().X_BL(*row) : tip.arm().X_BD();
  frame = {X_BF.p, X_BF.R, tip.columns()};
  if (!row) frame.R_BF *= toolFrame(tip.arm().effective());
  return status == deflection::KinematicsStatus::kConverged;
}

/// Returns the pose of the tool frame, or of the frame of `row`.
std::optional<ToolPose> poseAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                               const Measurement& measurement, const std::optional<int>& row,
                               const deflection::FlexibleKinematicsOptions& options) {
  const auto shape = deflection::solveFlexibleKinematics(arm, postureOf(measurement, arm, X_WB), options);
  if (shape.status != deflection::KinematicsStatus::kConverged) return std::nullopt;
  const auto& X_BF = row ? shape.rows.at(static_cast<std::size_t>(*row)).X_BL : shape.X_BD;
  return ToolPose{X_WB * X_BF.p,
                  row ? Matrix3d(X_WB.linear() * X_BF.R) : Matrix3d(X_WB.linear() * X_BF.R * shape.R_LT)};
}

}  // namespace

MeasurementPredictor::MeasurementPredictor(const deflection::Arm& arm)
    : arm_(arm), tip_(std::make_unique<deflection::TipDifferentiation>(arm)) {}

MeasurementPredictor::~MeasurementPredictor() = default;

Prediction MeasurementPredictor::predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                            const PredictionRequest& request) {
  FrameMotion frame;
  Prediction prediction;
  prediction.ok = solveFrame(*tip_, posture, variablesOf(request, arm_), std::nullopt, frame);
  prediction.value = X_WB * frame.p_BF;
  if (request.needsSlopes()) deriveOf(frame, {Matrix3d::Identity(), {}}, X_WB, request, false, prediction);
  return prediction;
}

Prediction predictMeasurement(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Measurement& measurement,
                              const PredictionRequest& request) {
  return MeasurementPredictor(arm).predict(X_WB, measurement, request);
}

Prediction predictMeasurement(const PlacedArm& placed, const Measurement& measurement,
                              const PredictionRequest& request) {
  return predictMeasurement(placed.arm, basePoseAt(placed, measurement), measurement, request);
}

Prediction MeasurementPredictor::predict(const Eigen::Isometry3d& X_WB, const Measurement& measurement,
                                         const PredictionRequest& request) {
  const auto variables = variablesOf(request, arm_);
  FrameMotion frame;
  Prediction prediction;
  prediction.ok = solveFrame(*tip_, postureOf(measurement, arm_, X_WB), variables, measurement.row, frame);
  if (const auto from = referencePostureOf(measurement, arm_, X_WB)) {
    FrameMotion reference;
    prediction.ok = solveFrame(*tip_, *from, variables, std::nullopt, reference) && prediction.ok;
    frame.subtract(reference, ownJointsOf(measurement, request, arm_));
  }
  predictOf(frame, arm_, X_WB, measurement, request, prediction);
  return prediction;
}

Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                      double load) {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  return MeasurementPredictor(arm).predictTip(X_WB, {q, load, deflection::gravityInBase(arm, X_WB)}, request);
}

std::optional<ToolPose> toolAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                               const Measurement& measurement, const deflection::FlexibleKinematicsOptions& options) {
  return poseAt(arm, X_WB, measurement, std::nullopt, options);
}

std::optional<ToolPose> toolAt(const PlacedArm& placed, const Measurement& measurement,
                               const deflection::FlexibleKinematicsOptions& options) {
  return toolAt(placed.arm, basePoseAt(placed, measurement), measurement, options);
}

std::optional<ToolPose> frameAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                const Measurement& measurement, const deflection::FlexibleKinematicsOptions& options) {
  return poseAt(arm, X_WB, measurement, measurement.row, options);
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

MatrixXd measurementCovariance(const deflection::Arm& arm, const Measurement& measurement, const MatrixXd& by_joints) {
  return encoderCovariance(arm, by_joints) + statedCovariance(measurement);
}

}  // namespace tubeplan::calibration
