// Proof that a straight joint motion is free, by adaptive bisection (Schwarzer, Saha and Latombe 2005). A stretch is
// free if the margins of its two ends together exceed the travel of any point between them. Thin obstacles are not
// missed.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "planner/collision/clearance.hpp"
#include "planner/collision/travel_bound.hpp"

namespace tubeplan::planner {

/// Function for the clearance of a posture [rad, m]. A NaN margin counts as blocked; `other` should then state the
/// reason.
using PostureClearance = std::function<Clearance(const Eigen::VectorXd& q)>;

struct MotionCheckOptions {
  /// Shortest travel of a stretch [m]; a shorter one that is still not proved counts as blocked.
  double least_travel = 1e-4;
  /// largest difference between proved clearance and least clearance met [m]; bisection continues until then. Infinite:
  /// only whether it is free matters.
  double accuracy = std::numeric_limits<double>::infinity();
  int max_checks = 100000;  ///< largest number of postures; a motion not proved by then counts as blocked
};

enum class MotionCheckStatus { kNotRun, kFree, kBlocked };

struct MotionCheckResult {
  MotionCheckStatus status = MotionCheckStatus::kNotRun;
  std::string reason;
  /// lower bound of the margin (distance less required clearance) along the whole motion [m]; only if free
  double proved_margin = std::numeric_limits<double>::quiet_NaN();
  /// the blocked posture, with the names of the pair; if free, the tightest posture met
  Clearance tightest;
  double where = std::numeric_limits<double>::quiet_NaN();  ///< place of `tightest`, as a share of the motion, 0 to 1
  int checks = 0;                                           ///< number of postures checked
};

/// Checks the motion q0 + s (q1 - q0), s from 0 to 1.
[[nodiscard]] MotionCheckResult checkMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                            const PostureClearance& clearance_of, const TravelBound& travel,
                                            const MotionCheckOptions& options = {});

}  // namespace tubeplan::planner
