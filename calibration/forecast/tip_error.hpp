// Lateral error of the true tip at the goals of a calibrated arm: due to the joint readings, the uncertainty of the
// base and the arm's parameters, and the model error.
//
// The errors of base and parameters are correlated, because the same touches or measurements determine both. Errors
// that compensate each other do not move the tip. With J the tip's Jacobian with respect to base and parameters and P
// their covariance, the covariance of the tip is
//     J P J^T + E + m^2 I,
// where E is the covariance due to the joint readings and m the model error, independent in each posture. If m was
// estimated with few degrees of freedom, m^2 has a scaled inverse chi-square distribution, and the distribution of the
// tip error is a mixture.
#pragma once

#include <optional>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// Stated model error: standard deviation of each coordinate of the tip, independent in each posture.
struct StatedModelError {
  double sigma = 0;            ///< standard deviation of each coordinate [m]
  int degrees_of_freedom = 0;  ///< degrees of freedom of the estimate of sigma; 0 means that sigma is known
};

/// Input of findTipError(): the placed arm and its uncertainty, and the postures of the goals.
struct TipErrorQuestion {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  double load = 0;               ///< load hung from the tip [N]
  JointUncertainty uncertainty;  ///< uncertainty of base and parameters together, about X_WB and `arm`
  std::optional<StatedModelError> model_error;
  std::vector<Eigen::VectorXd> postures;
};

/// One normal distribution of a mixture: lateral offset of the true tip from the predicted tip [m].
struct TipErrorCase {
  double weight = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Returns the mixture for each posture, with weights that add up to 1; empty for a posture whose shape does not
/// converge.
[[nodiscard]] std::vector<std::vector<TipErrorCase>> findTipError(const TipErrorQuestion& question);

}  // namespace tubeplan::calibration
