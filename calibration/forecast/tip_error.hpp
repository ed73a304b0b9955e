// Lateral error of the true tip at the goals of a calibrated arm: from the joints' readings, from the uncertainty of
// the base and of the arm's numbers, and from the model's own error.
//
// Base and numbers are uncertain together: touches or a campaign determine both, and an error of
// one that the other compensates moves no tip. With J the tip's slopes by them and P their covariance the tip's is
//     J P J^T + E + m^2 I,
// E that of the joints' readings and m the model's own error, independent in each posture. If m was found from few
// degrees of freedom, it has a chi-square distribution, and the tip's error is a mixture.
#pragma once

#include <optional>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// Stated error of the model: standard deviation of each coordinate of the tip, independent in each posture.
struct StatedModelError {
  double sigma = 0;            ///< [m]
  int degrees_of_freedom = 0;  ///< degrees of freedom of its estimate; 0: known
};

/// Input of findTipError(): the placed arm, and its uncertainty.
struct TipErrorQuestion {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  double load = 0;               ///< [N]
  JointUncertainty uncertainty;  ///< about `arm` and X_WB
  std::optional<StatedModelError> model_error;
  std::vector<Eigen::VectorXd> postures;
};

/// One normal distribution of a mixture: lateral offset of the true tip from the model's [m].
struct TipErrorCase {
  double weight = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Returns the mixture for each posture, with weights adding up to 1; empty if the shape does not converge.
[[nodiscard]] std::vector<std::vector<TipErrorCase>> findTipError(const TipErrorQuestion& question);

}  // namespace tubeplan::calibration
