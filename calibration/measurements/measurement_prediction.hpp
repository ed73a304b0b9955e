// Prediction of a measurement of any kind by the arm model, with exact derivatives.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_posture.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::deflection {
class TipDifferentiation;
}

namespace tubeplan::calibration {

/// Derivatives requested in addition to the value.
struct PredictionRequest {
  std::vector<deflection::Variable> numbers = {};  ///< parameters of the arm, or any other variable of the tip
  bool by_base = false;
  bool by_joints = false;

  [[nodiscard]] bool needsSlopes() const { return !numbers.empty() || by_base || by_joints; }
};

/// Predicted values of a measurement, as its kind defines them (measurements/): up to 6 rows [m].
struct Prediction {
  bool ok = false;  ///< true if the deflected shape converged; false if the other members are invalid
  Eigen::VectorXd value;
  /// Derivatives with respect to the requested parameters (rows x parameters), to a small displacement of the base
  /// (rows x 6), and to the joints (rows x joints, followed by the joints of a displacement's reference).
  Eigen::MatrixXd by_numbers, by_base, by_joints;
};

/// Predicts successive measurements of one arm. Each thread needs its own predictor. `arm` must outlive the predictor
/// and must not change.
class MeasurementPredictor {
 public:
  explicit MeasurementPredictor(const deflection::Arm& arm);
  ~MeasurementPredictor();

  /// Predicts a measurement of the arm, for a base at `X_WB`.
  [[nodiscard]] Prediction predict(const Eigen::Isometry3d& X_WB, const Measurement& measurement,
                                   const PredictionRequest& request = {});

  /// Predicts the tip's position in the world frame [m] with its derivatives, ignoring any scale error of the measuring
  /// system.
  [[nodiscard]] Prediction predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                      const PredictionRequest& request = {});

 private:
  const deflection::Arm& arm_;
  std::unique_ptr<deflection::TipDifferentiation> tip_;
};

/// Predicts a single measurement of the arm, for a base at `X_WB`.
[[nodiscard]] Prediction predictMeasurement(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const Measurement& measurement, const PredictionRequest& request = {});
[[nodiscard]] Prediction predictMeasurement(const PlacedArm& placed, const Measurement& measurement,
                                            const PredictionRequest& request = {});

/// Predicts the tip of the arm for a base at `X_WB`, with the derivatives with respect to base and joints. They include
/// the effect of a base rotation on gravity in the base frame.
[[nodiscard]] Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                                    double load);

/// Returns the pose of the tool at a measurement, even if the measurement measures another frame; empty if the shape
/// does not converge.
[[nodiscard]] std::optional<ToolPose> toolAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                             const Measurement& measurement,
                                             const deflection::FlexibleKinematicsOptions& options = {});
[[nodiscard]] std::optional<ToolPose> toolAt(const PlacedArm& placed, const Measurement& measurement,
                                             const deflection::FlexibleKinematicsOptions& options = {});

/// Returns the pose of the frame that the measurement measures: the tool frame, or the frame of the measurement's row.
/// Empty if the shape does not converge.
[[nodiscard]] std::optional<ToolPose> frameAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                              const Measurement& measurement,
                                              const deflection::FlexibleKinematicsOptions& options = {});

/// Returns the covariance of predicted values [m^2] caused by encoder noise alone, through `by_joints` (rows x joints).
[[nodiscard]] Eigen::MatrixXd encoderCovariance(const deflection::Arm& arm, const Eigen::MatrixXd& by_joints);

/// Returns the covariance of the tip's position [m^2] due to the uncertainty of the base pose and to encoder noise.
[[nodiscard]] Eigen::Matrix3d tipCovariance(const deflection::Arm& arm, const Prediction& tip,
                                            const Eigen::Matrix<double, 6, 6>& base_covariance);

/// Returns the covariance of a measurement [m^2]: its own noise (statedCovariance()) and the encoder noise through
/// `by_joints`.
[[nodiscard]] Eigen::MatrixXd measurementCovariance(const deflection::Arm& arm, const Measurement& measurement,
                                                    const Eigen::MatrixXd& by_joints);

}  // namespace tubeplan::calibration
