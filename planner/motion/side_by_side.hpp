// A clearance that can be asked of many postures at once, where that costs less than one after the other.
#pragma once

#include <vector>

#include "planner/collision/arm_clearance.hpp"
#include "planner/motion/motion_check.hpp"

namespace tubeplan::planner {

/// As good as any PostureClearance; a motion's proof that is handed one finds out (std::function::target) and asks for
/// a whole level of its bisection together.
struct SideBySideClearance {
  PostureClearance alone;
  std::function<MarginsSideBySide(const PostureColumns&)> many;  ///< what `alone` says, bit for bit

  Clearance operator()(const Eigen::VectorXd& q) const { return alone(q); }
};

/// Of an arm, `spare` [m] taken off; `clearance` must outlive it.
[[nodiscard]] PostureClearance sideBySide(const ArmClearance& clearance, ContactRule rule, double spare);

}  // namespace tubeplan::planner
