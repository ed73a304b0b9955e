// Points that outline a solid, for drawings.
#pragma once

#include <vector>

#include "planner/scene/shape.hpp"

namespace tubeplan::planner {

/// Returns points on the solid's surface, in its frame F [m], each once: its corners, or a fine net where it is round.
/// Their convex hull lies within the solid.
[[nodiscard]] std::vector<Eigen::Vector3d> outlineOf(const Solid& solid);

}  // namespace tubeplan::planner
