// Probability that a normally distributed point of the plane lies in a disc or a ring about the origin.
#pragma once

#include <Eigen/Core>

namespace tubeplan::calibration {

/// Probability, with its derivatives with respect to the point's mean.
struct RegionProbability {
  double p = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
};

/// Returns the probability that a point with this mean and covariance lies farther than `lower` and at most `upper`
/// from the origin; `upper` may be infinite.
[[nodiscard]] RegionProbability ringProbability(double lower, double upper, const Eigen::Vector2d& mean,
                                                const Eigen::Matrix2d& covariance);

/// Probability of a ring for a point with unit covariance at the distance `mean` from the origin, with its derivative
/// with respect to this distance.
struct RadialProbability {
  double p = 0, slope = 0;
};
[[nodiscard]] RadialProbability ringProbability(double lower, double upper, double mean);

}  // namespace tubeplan::calibration
