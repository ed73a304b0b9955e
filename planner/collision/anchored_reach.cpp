#include "planner/collision/anchored_reach.hpp"

#include <algorithm>
#include <cassert>

namespace tubeplan::planner {

AnchoredReach anchoredReachOf(const deflection::Arm& arm, const Scene& scene, std::vector<double> body_reach) {
  deflection::AnchoredRows rows = deflection::anchoredRows(arm);
  const auto isSlid = [&](std::size_t row) { return rows.slid[row] != 0; };
  for (std::size_t row = 0; row < body_reach.size(); ++row)
    if (isSlid(row)) body_reach[row] = 0;
  for (const Body& body : scene.bodies) {
    const auto row = static_cast<std::size_t>(body.frame_index);
    assert(row < rows.slid.size() && row < body_reach.size());
    if (!isSlid(row)) continue;
    const Eigen::Vector3d origin = rows.slid[row] * Eigen::Vector3d::UnitZ();
    const double reach = (static_cast<const Solid&>(*body.shape).farthestFrom(origin) - origin).norm();
    body_reach[row] = std::max(body_reach[row], reach);
  }
  return {std::move(rows.arm), std::move(body_reach)};
}

}  // namespace tubeplan::planner
