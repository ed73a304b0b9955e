// How far the arm is from what it must not touch, in one posture.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// The nearest approach in one posture.
struct Clearance {
  /// m; a lower value of the true distance, negative where things overlap. Infinite where there is nothing to touch.
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// m; distance less what the scene requires. Free means zero or more; NaN means it could not be computed, and is not
  /// free.
  double margin = std::numeric_limits<double>::quiet_NaN();
  std::string body;   ///< the arm's body that comes nearest
  std::string other;  ///< to this obstacle, or other body
  Eigen::Vector3d point_W = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< of the body
};

/// "forearm is 0.0021 m from divider, 0.0064 m required" [m].
[[nodiscard]] std::string describe(const Clearance& clearance);

/// Greatest distance of any body point of a link from the origin of its frame [m], one per link; 0 without bodies.
[[nodiscard]] std::vector<double> bodyReachOf(const Scene& scene);

}  // namespace tubeplan::planner
