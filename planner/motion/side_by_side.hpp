// A clearance that can be computed for many postures together, at less cost than one after the other.
#pragma once

#include <vector>

#include "planner/collision/arm_clearance.hpp"
#include "planner/motion/motion_check.hpp"

namespace tubeplan::planner {

/// A PostureClearance for many postures. The proof of a motion recognises it (std::function::target), and computes a
/// whole level of its bisection together.
struct SideBySideClearance {
  PostureClearance alone;
  /// Function for many postures, with the same results as `alone`, bit for bit.
  std::function<MarginsSideBySide(const PostureColumns&)> many;

  Clearance operator()(const Eigen::VectorXd& q) const { return alone(q); }
};

/// Returns the clearance of an arm with `spare` [m] subtracted; `clearance` must outlive it.
[[nodiscard]] PostureClearance sideBySide(const ArmClearance& clearance, ContactRule rule, double spare);

}  // namespace tubeplan::planner
