// How far the true tip may be off, sideways, where a calibrated arm is sent to: by the joints' readings, by where the
// base may stand and how the arm's numbers may be otherwise, and by the model's own error.
//
// Base and numbers are uncertain together: what touches or a campaign have placed is placed for both, and an error of
// one that the other takes up moves no tip. With J the tip's slopes by them and P their covariance the tip's is
//     J P J^T + E + m^2 I,
// E that of the joints' readings and m the model's own error, another in each posture. Where m was found by few degrees
// of freedom it may be larger or smaller, as a chi-square has it, and the tip's error is a mixture.
#pragma once

#include <optional>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// The model's error as somebody found it: standard deviation of each coordinate of the tip, another in each posture.
struct StatedModelError {
  double sigma = 0;            ///< m
  int degrees_of_freedom = 0;  ///< by which it was found; 0: known
};

/// What is asked: where the arm stands, and what is known of that.
struct TipErrorQuestion {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  double load = 0;               ///< N
  JointUncertainty uncertainty;  ///< about `arm` and X_WB
  std::optional<StatedModelError> model_error;
  std::vector<Eigen::VectorXd> postures;
};

/// One of the normal distributions of a mixture: sideways offset of the true tip from the model's [m].
struct TipErrorCase {
  double weight = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Returns the mixture for each posture, weights adding up to 1; empty where the shape does not converge.
[[nodiscard]] std::vector<std::vector<TipErrorCase>> findTipError(const TipErrorQuestion& question);

}  // namespace tubeplan::calibration
