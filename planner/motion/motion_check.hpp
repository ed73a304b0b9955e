// Proof that a straight motion in joint space is free, by adaptive bisection (Schwarzer, Saha and Latombe 2005). A
// segment is free if the sum of the margins at its two ends exceeds the travel of any point along it, so that even thin
// obstacles are not missed.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "planner/collision/clearance.hpp"
#include "planner/collision/travel_bound.hpp"

namespace tubeplan::planner {

/// Function that returns the clearance of a posture [rad, m]. A posture with a NaN margin is treated as blocked;
/// `other` should then state the reason.
using PostureClearance = std::function<Clearance(const Eigen::VectorXd& q)>;

struct MotionCheckOptions {
  /// Travel below which a segment is not bisected [m]; a shorter segment that is not proved is treated as blocked.
  double least_travel = 1e-4;
  /// Largest difference between the proved margin and the smallest margin met [m]; bisection continues until this
  /// accuracy is reached. If infinite, bisection stops as soon as the motion is proved free.
  double accuracy = std::numeric_limits<double>::infinity();
  /// Largest number of postures checked; a motion that needs more is treated as blocked.
  int max_checks = 100000;
};

enum class MotionCheckStatus { kNotRun, kFree, kBlocked };

struct MotionCheckResult {
  MotionCheckStatus status = MotionCheckStatus::kNotRun;
  std::string reason;
  /// lower bound of the margin (distance minus required clearance) along the whole motion [m]; NaN if not free
  double proved_margin = std::numeric_limits<double>::quiet_NaN();
  /// clearance of the blocked posture, with the names of the pair; if free, of the tightest posture met
  Clearance tightest;
  double where = std::numeric_limits<double>::quiet_NaN();  ///< position of `tightest` along the motion, from 0 to 1
  int checks = 0;                                           ///< number of postures checked
};

/// Checks the straight motion q0 + s (q1 - q0), with s from 0 to 1.
[[nodiscard]] MotionCheckResult checkMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                            const PostureClearance& clearance_of, const TravelBound& travel,
                                            const MotionCheckOptions& options = {});

}  // namespace tubeplan::planner
