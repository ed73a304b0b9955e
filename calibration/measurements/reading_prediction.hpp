// Prediction of a reading of any kind by the model, with exact derivatives.
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

/// Derivatives wanted besides the value.
struct PredictionRequest {
  std::vector<deflection::Variable> numbers = {};  ///< of the arm; also any other variable of the tip
  bool by_base = false;
  bool by_joints = false;

  [[nodiscard]] bool asksForSlopes() const { return !numbers.empty() || by_base || by_joints; }
};

/// Predicted values of a reading by its kind (measurements/): up to 6 rows [m].
struct Prediction {
  bool ok = false;  ///< true if the deflected shape converged; otherwise the rest is not to be used
  Eigen::VectorXd value;
  /// Rows x numbers; rows x 6, at a zero step; rows x joints, then those of the reference of a displacement.
  Eigen::MatrixXd by_numbers, by_base, by_joints;
};

/// A predictor of one reading after another of one arm. Each thread needs its own. `arm` must outlive it, and must not
/// change.
class ReadingPredictor {
 public:
  explicit ReadingPredictor(const deflection::Arm& arm);
  ~ReadingPredictor();

  /// Predicts a reading of the arm with its base at `X_WB`.
  [[nodiscard]] Prediction predict(const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                   const PredictionRequest& request = {});

  /// Predicts the tip's place in the world [m] with its derivatives, without an error of the measuring scale.
  [[nodiscard]] Prediction predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                      const PredictionRequest& request = {});

 private:
  const deflection::Arm& arm_;
  std::unique_ptr<deflection::TipDifferentiation> tip_;
};

/// Predicts a single reading of the arm with its base at `X_WB`.
[[nodiscard]] Prediction predictReading(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const Measurement& reading, const PredictionRequest& request = {});
[[nodiscard]] Prediction predictReading(const PlacedArm& placed, const Measurement& reading,
                                        const PredictionRequest& request = {});

/// Predicts the tip of the arm with its base at `X_WB`, with its derivatives by base and joints. Gravity turns in the
/// base frame as the base turns.
[[nodiscard]] Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                                    double load);

/// Returns the pose of the tool at a reading, even if the reading is of another frame; nothing if the shape does not
/// converge.
[[nodiscard]] std::optional<ToolPose> toolAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                             const Measurement& reading,
                                             const deflection::FlexibleKinematicsOptions& options = {});
[[nodiscard]] std::optional<ToolPose> toolAt(const PlacedArm& placed, const Measurement& reading,
                                             const deflection::FlexibleKinematicsOptions& options = {});

/// Returns the frame that the reading measures: the tool's, or that of its row.
[[nodiscard]] std::optional<ToolPose> frameAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                              const Measurement& reading,
                                              const deflection::FlexibleKinematicsOptions& options = {});

/// Returns the covariance [m^2] of values caused by encoder noise alone, through `by_joints` (rows x joints).
[[nodiscard]] Eigen::MatrixXd encoderCovariance(const deflection::Arm& arm, const Eigen::MatrixXd& by_joints);

/// Returns the covariance [m^2] of the tip's place, caused by that of the base and the encoders' noise together.
[[nodiscard]] Eigen::Matrix3d tipCovariance(const deflection::Arm& arm, const Prediction& tip,
                                            const Eigen::Matrix<double, 6, 6>& base_covariance);

/// Returns the covariance [m^2] of a reading: its own noise (statedCovariance()), and the encoders' through
/// `by_joints`.
[[nodiscard]] Eigen::MatrixXd readingCovariance(const deflection::Arm& arm, const Measurement& reading,
                                                const Eigen::MatrixXd& by_joints);

}  // namespace tubeplan::calibration
