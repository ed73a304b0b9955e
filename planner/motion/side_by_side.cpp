#include "planner/motion/side_by_side.hpp"

namespace tubeplan::planner {

PostureClearance sideBySide(const ArmClearance& clearance, ContactRule rule, double spare) {
  return SideBySideClearance{
      [&clearance, rule, spare](const Eigen::VectorXd& q) { return clearance.withSpare(q, rule, spare); },
      [&clearance, rule, spare](const PostureColumns& q) {
        MarginsSideBySide found = clearance.together(q, rule);
        for (double& margin : found.margins) margin -= spare;
        found.clearance.margin -= spare;
        return found;
      }};
}

}  // namespace tubeplan::planner
