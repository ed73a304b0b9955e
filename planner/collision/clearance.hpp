// Clearance of the arm from everything that it must not touch, in one posture.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// The nearest approach in one posture.
struct Clearance {
  /// lower bound of the true distance [m], negative if bodies overlap; infinite if there is nothing to touch
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// distance less the clearance that the scene requires [m]; free if zero or more; NaN: could not be computed, and is
  /// not free
  double margin = std::numeric_limits<double>::quiet_NaN();
  std::string body;   ///< the arm's body that comes nearest
  std::string other;  ///< obstacle or other body that it comes nearest to
  /// Nearest point of the body [m].
  Eigen::Vector3d point_W = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Returns "forearm is 0.0021 m from divider, 0.0064 m required" [m].
[[nodiscard]] std::string describe(const Clearance& clearance);

/// Returns the greatest distance of any body point of each link from the origin of its frame [m]; 0 without bodies.
[[nodiscard]] std::vector<double> bodyReachOf(const Scene& scene);

}  // namespace tubeplan::planner
