// Upper bound on the travel of any point of the arm during a straight motion in joint space.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::planner {

/// Bound on the travel during a straight motion in joint space: the sum of |dq_j| times `reach_per_joint[j]`. For a
/// revolute joint, `reach_per_joint` is an upper bound of the distance of any body point beyond the joint from its axis
/// [m/rad]. For a prismatic joint it is 1 [m/m]. If frames of other links follow the joint, the corresponding distance
/// for each of them, times its ratio, is added. The sum also bounds how far two bodies of the arm can approach each
/// other.
struct TravelBound {
  Eigen::VectorXd reach_per_joint;

  /// Returns the bound for a motion from q0 to q1 [m].
  [[nodiscard]] double operator()(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) const {
    return reach_per_joint.dot((q1 - q0).cwiseAbs());
  }
};

/// Lengths of a link that determine the travel of its points.
struct LinkReach {
  /// Largest distance between the origins of this link's frame and the next link's frame [m]; unused for the last link.
  double step = 0;
  double body = 0;  ///< largest distance of a body point from the origin of the link's frame (bodyReachOf()) [m]
  enum class Joint {
    kNone,
    kRevolute,
    /// Translates along the z axis of this frame; a revolute joint turns about that axis.
    kPrismatic
  } joint = Joint::kNone;
  /// Joints of other links that also turn this link's frame, with their ratios.
  std::vector<deflection::FollowedJoint> follows = {};
};

/// Returns a bound that holds in every posture. `factor` (1 or more) covers effects that the lengths do not include:
/// lengthening of links, and changes of the arm's deflection during the motion.
[[nodiscard]] TravelBound travelBoundOf(std::span<const LinkReach> links, double factor);

}  // namespace tubeplan::planner
