// Clearance by another way than the planner's: nothing is known of a shape but how far a point is from it.
//
// A point that moves by h changes its distance by at most h, so the least distance along a capsule's axis is found to any accuracy
// by halving the axis where it could still be less (Piyavskii 1972). Slow, short and without special cases: for checking.
#pragma once

#include <span>

#include "planner/scene.hpp"

namespace tubeplan::planner {

/// A lower bound, within `accuracy` [m], of the distance between a capsule and a shape; `capsule` in the shape's frame.
[[nodiscard]] double lipschitzDistance(const Capsule& capsule, const Shape& shape, double accuracy = 1e-6);

/// Lower bound of the least margin (distance less the scene's clearance) of all pairs that may not touch, the rows' bodies being at
/// X_WL [m]. `names` gets the tightest pair, "tool, divider".
[[nodiscard]] double lipschitzMargin(const Scene& scene, std::span<const Eigen::Isometry3d> X_WL, double accuracy, std::string* names);

}  // namespace tubeplan::planner
