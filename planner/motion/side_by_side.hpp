// A clearance function that computes many postures together, at less cost than one after the other.
#pragma once

#include <vector>

#include "planner/collision/arm_clearance.hpp"
#include "planner/motion/motion_check.hpp"

namespace tubeplan::planner {

/// A PostureClearance that can also compute the margins of many postures at once. The proof of a motion recognises this
/// type (std::function::target), and computes a whole level of its bisection together.
struct SideBySideClearance {
  PostureClearance alone;
  /// Returns the margins of many postures, bitwise identical to the results of `alone`.
  std::function<MarginsSideBySide(const PostureColumns&)> many;

  Clearance operator()(const Eigen::VectorXd& q) const { return alone(q); }
};

/// Returns the function for an arm's clearance with `spare` [m] subtracted from the margin. `clearance` must outlive
/// the function.
[[nodiscard]] PostureClearance sideBySide(const ArmClearance& clearance, ContactRule rule, double spare);

}  // namespace tubeplan::planner
