// Probability that a normally distributed point of the plane lies in the common part of several discs.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tubeplan::calibration {

struct Disc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0;
};

/// The points that lie in all of these discs: the whole plane if there are none, and no point if a radius is negative.
using CommonDiscs = std::vector<Disc>;

/// Returns the same points by fewer discs: without those that have another of the discs in them.
[[nodiscard]] CommonDiscs withoutRedundant(const CommonDiscs& discs);

/// Probability, with its derivatives with respect to the point's mean.
struct RegionProbability {
  double p = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
};

/// Returns the probability that a point with this mean and covariance lies in all discs.
[[nodiscard]] RegionProbability probabilityWithin(const CommonDiscs& discs, const Eigen::Vector2d& mean,
                                                  const Eigen::Matrix2d& covariance);

}  // namespace tubeplan::calibration
