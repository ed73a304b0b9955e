// What the model expects a reading to be, whatever its kind, with exact derivatives.
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

/// What is asked for beside the value.
struct PredictionRequest {
  std::vector<deflection::Variable> numbers;  ///< of the arm; also any other variable of the tip
  bool by_base = false;
  bool by_joints = false;

  [[nodiscard]] bool asksForSlopes() const { return !numbers.empty() || by_base || by_joints; }
};

/// What the reading's kind measures of the tool (measurements/): up to 6 rows, m.
struct Prediction {
  bool ok = false;  ///< whether the deflected shape settled; the rest is not to be used otherwise
  Eigen::VectorXd value;
  Eigen::MatrixXd by_numbers, by_base, by_joints;  ///< rows x numbers; rows x 6, at a zero step; rows x joints,
                                                   ///< of a way from another reading those of that one after its own
};

/// Predicts reading after reading of one arm; each thread needs its own. `arm` must outlive it, and stay as it is.
class ReadingPredictor {
 public:
  explicit ReadingPredictor(const deflection::Arm& arm);
  ~ReadingPredictor();

  /// The arm stands at `X_WB`.
  [[nodiscard]] Prediction predict(const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                   const PredictionRequest& request = {});

  /// The tip's place in the world [m] and its derivatives, by the true measure of length.
  [[nodiscard]] Prediction predictTip(const Eigen::Isometry3d& X_WB, const deflection::Posture& posture,
                                      const PredictionRequest& request = {});

 private:
  const deflection::Arm& arm_;
  std::unique_ptr<deflection::TipDifferentiation> tip_;
};

/// The same of a single reading.
[[nodiscard]] Prediction predictReading(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                        const Measurement& reading, const PredictionRequest& request = {});

/// The tip where the arm stands at `X_WB`, with its derivatives by base and joints. Gravity turns in the base frame as
/// the base turns.
[[nodiscard]] Prediction predictTip(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const Eigen::VectorXd& q,
                                    double load);

/// The tool where the reading was taken, whatever it is of; nothing where the shape does not converge.
[[nodiscard]] std::optional<ToolPose> toolAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                             const Measurement& reading,
                                             const deflection::FlexibleKinematicsOptions& options = {});

/// The frame that the reading is of: the tool's, or that of its row.
[[nodiscard]] std::optional<ToolPose> frameAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                              const Measurement& reading,
                                              const deflection::FlexibleKinematicsOptions& options = {});

/// Covariance [m^2] of what the joints' readings alone leave open, through `by_joints` (rows x joints).
[[nodiscard]] Eigen::MatrixXd encoderCovariance(const deflection::Arm& arm, const Eigen::MatrixXd& by_joints);

/// Covariance [m^2] of the tip's place by its derivatives, from that of the base and the encoders' noise together.
[[nodiscard]] Eigen::Matrix3d tipCovariance(const deflection::Arm& arm, const Prediction& tip,
                                            const Eigen::Matrix<double, 6, 6>& base_covariance);

/// Covariance [m^2] of a reading: its own noise (statedCovariance), and the encoders' through `by_joints`.
[[nodiscard]] Eigen::MatrixXd readingCovariance(const deflection::Arm& arm, const Measurement& reading,
                                                const Eigen::MatrixXd& by_joints);

}  // namespace tubeplan::calibration
