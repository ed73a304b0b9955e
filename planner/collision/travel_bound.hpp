// How far any point of the arm can travel in a straight joint motion, at most.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::planner {

/// Travel in a motion straight in joint space is at most the sum of |dq_j| times `reach_per_joint[j]`: for a revolute
/// joint the greatest distance of any body point beyond it from its axis [m/rad], and as much for each frame that
/// follows it by the turn there; for a sliding one 1 [m/m]. The same sum bounds how fast two of the arm's own bodies
/// near one another, as only the joints between them count.
struct TravelBound {
  Eigen::VectorXd reach_per_joint;

  /// m
  [[nodiscard]] double operator()(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) const {
    return reach_per_joint.dot((q1 - q0).cwiseAbs());
  }
};

/// The arm's lengths, as far as travel goes; one entry per link.
struct LinkReach {
  double step =
      0;  ///< m; greatest distance between the origins of this link's frame and the next one's (unused for the last)
  double body = 0;  ///< m; greatest distance of a body point from the frame's origin (bodyReachOf)
  enum class Joint {
    kNone,
    kRevolute,
    kPrismatic
  } joint = Joint::kNone;                               ///< which ends at this frame, about or along its z
  std::vector<deflection::FollowedJoint> follows = {};  ///< of a frame without a joint of its own: what turns it
};

/// A bound that holds in every posture. `factor` (1 or more) covers what the lengths leave out: links that lengthen,
/// and the arm's deflection changing on the way, which moves points without a joint moving.
[[nodiscard]] TravelBound travelBoundOf(std::span<const LinkReach> links, double factor);

}  // namespace tubeplan::planner
