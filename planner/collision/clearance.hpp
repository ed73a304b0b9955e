// Clearance in one posture of the arm from every obstacle and body that it must not touch.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// Nearest approach of the arm in one posture to anything that it must not touch.
struct Clearance {
  /// lower bound of the true distance [m]; negative if bodies overlap, infinite if there is nothing to collide with
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// distance minus the clearance that the scene requires [m]. The posture is free if the margin is zero or more; A NaN
  /// margin could not be computed, and the posture is treated as not free.
  double margin = std::numeric_limits<double>::quiet_NaN();
  std::string body;  ///< body of the arm that comes nearest to `other`
  /// Obstacle or other body of the arm that `body` comes nearest to; the reason if the margin is NaN.
  std::string other;
  /// Point of the nearest approach, in the world [m].
  Eigen::Vector3d point_W = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Returns a sentence such as "forearm is 0.0021 m from divider, 0.0064 m required".
[[nodiscard]] std::string describe(const Clearance& clearance);

/// For each link, returns the largest distance of a body point from the origin of the link's frame [m]; 0 for a link
/// without bodies.
[[nodiscard]] std::vector<double> bodyReachOf(const Scene& scene);

}  // namespace tubeplan::planner
