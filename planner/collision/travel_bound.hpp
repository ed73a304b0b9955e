// Upper bound on the travel of any point of the arm in a straight joint motion.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::planner {

/// Bound on the travel in a motion straight in joint space: the sum of |dq_j| times `reach_per_joint[j]`. For a
/// revolute joint this is the greatest distance of any body point beyond it from its axis [m/rad], and as much for each
/// frame that follows it with its ratio; for a sliding one 1 [m/m]. The sum also bounds the approach of two of the
/// arm's own bodies, because only the joints between them matter.
struct TravelBound {
  Eigen::VectorXd reach_per_joint;

  /// Returns the bound for a motion from q0 to q1 [m].
  [[nodiscard]] double operator()(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) const {
    return reach_per_joint.dot((q1 - q0).cwiseAbs());
  }
};

/// Lengths of a link that matter for travel.
struct LinkReach {
  /// Greatest distance between the origins of this link's frame and the next one's [m]; unused for the last.
  double step = 0;
  double body = 0;  ///< greatest distance of a body point from the frame's origin (bodyReachOf) [m]
  enum class Joint {
    kNone,
    kRevolute,
    /// Joint that ends at this frame, about or along its z.
    kPrismatic
  } joint = Joint::kNone;
  std::vector<deflection::FollowedJoint> follows = {};  ///< joints that turn a frame without a joint of its own
};

/// Returns a bound that holds in every posture. `factor` (1 or more) covers effects that the lengths do not include:
/// links that lengthen, and changes of the arm's deflection during the motion.
[[nodiscard]] TravelBound travelBoundOf(std::span<const LinkReach> links, double factor);

}  // namespace tubeplan::planner
