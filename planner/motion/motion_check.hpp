// Proof that a straight joint motion is free, by adaptive bisection (Schwarzer, Saha and Latombe 2005): a stretch is
// free when what its two ends have to spare together exceeds what any point can travel between them. Nothing thin is
// stepped over.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "planner/collision/clearance.hpp"
#include "planner/collision/travel_bound.hpp"

namespace tubeplan::planner {

/// The clearance of a posture [rad, m]. A margin that is NaN counts as blocked; then `other` should say why.
using PostureClearance = std::function<Clearance(const Eigen::VectorXd& q)>;

struct MotionCheckOptions {
  double least_travel = 1e-4;  ///< m; a stretch with less travel that is still not proved counts as blocked
  /// m; go on bisecting until the proved clearance is within this of the least one met. Infinite: free or not is
  /// enough.
  double accuracy = std::numeric_limits<double>::infinity();
  int max_checks = 100000;  ///< of postures; a motion not proved by then counts as blocked
};

enum class MotionCheckStatus { kNotRun, kFree, kBlocked };

struct MotionCheckResult {
  MotionCheckStatus status = MotionCheckStatus::kNotRun;
  std::string reason;
  /// m; along the whole motion the margin (distance less what is required) is at least this. Only when free.
  double proved_margin = std::numeric_limits<double>::quiet_NaN();
  /// Where it is blocked; when free, the tightest posture met. The names of the pair are in it.
  Clearance tightest;
  double where = std::numeric_limits<double>::quiet_NaN();  ///< of `tightest`, as a share of the motion, 0 to 1
  int checks = 0;                                           ///< postures asked about
};

/// Checks the motion q0 + s (q1 - q0), s from 0 to 1.
[[nodiscard]] MotionCheckResult checkMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                            const PostureClearance& clearance_of, const TravelBound& travel,
                                            const MotionCheckOptions& options = {});

}  // namespace tubeplan::planner
