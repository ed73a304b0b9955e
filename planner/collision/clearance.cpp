#include "planner/collision/clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tubeplan::planner {

std::string describe(const Clearance& clearance) {
  if (clearance.body.empty() && clearance.other.empty())
    return std::isfinite(clearance.margin)
               ? fmt::format("the arm clears everything by {:.4g} m more than required", clearance.margin)
               : "nothing is near the arm";
  if (std::isnan(clearance.distance))
    return clearance.body.empty() ? clearance.other : fmt::format("{}: {}", clearance.body, clearance.other);
  const double required = clearance.distance - clearance.margin;
  if (clearance.distance < 0) return fmt::format("{} collides with {}", clearance.body, clearance.other);
  return fmt::format("{} is {:.4f} m from {}, {:.4f} m required", clearance.body, clearance.distance, clearance.other,
                     required);
}

std::vector<double> bodyReachOf(const Scene& scene) {
  std::vector<double> reach(scene.links.size(), 0.0);
  for (const Body& body : scene.bodies) {
    const auto& solid = dynamic_cast<const Solid&>(*body.shape);
    double& farthest = reach[static_cast<std::size_t>(body.frame_index)];
    farthest = std::max(farthest, solid.farthestFrom(Eigen::Vector3d::Zero()).norm());
  }
  return reach;
}

}  // namespace tubeplan::planner
