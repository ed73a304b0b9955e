#include "planner/motion_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace tubeplan::planner {
namespace {

struct Sample {
  double s;       ///< place on the motion, 0 to 1
  double margin;  ///< m
};

struct Stretch {
  Sample a, b;
};

class MotionProof {
 public:
  MotionProof(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const PostureClearance& clearance_of,
              const TravelBound& travel, const MotionCheckOptions& options)
      : q0_(q0), q1_(q1), clearance_of_(clearance_of), travel_(travel(q0, q1)), options_(options) {}

  MotionCheckResult run() {
    const Sample start = sampleAt(0), goal = travel_ > 0 ? sampleAt(1) : start;
    if (isBlocked()) return result_;
    result_.proved_margin = std::min(start.margin, goal.margin);
    // Breadth first: what blocks a motion is mostly met within the first few halvings.
    std::deque<Stretch> open;
    if (travel_ > 0) open.push_back({start, goal});
    while (!open.empty()) {
      const Stretch stretch = open.front();
      open.pop_front();
      if (takeAsProved(stretch)) continue;
      if (travelOf(stretch) < options_.least_travel)
        return blocked("too tight to prove free: " + describe(result_.tightest));
      if (result_.checks >= options_.max_checks)
        return blocked(fmt::format("not proved free in {} postures: {}", result_.checks, describe(result_.tightest)));
      const Sample middle = sampleAt(0.5 * (stretch.a.s + stretch.b.s));
      if (isBlocked()) return result_;
      open.push_back({stretch.a, middle});
      open.push_back({middle, stretch.b});
    }
    result_.status = MotionCheckStatus::kFree;
    return result_;
  }

 private:
  double travelOf(const Stretch& stretch) const { return travel_ * (stretch.b.s - stretch.a.s); }

  /// Nowhere on the stretch is the margin less: at the place where what is left of both ends' margins is equal.
  double lowerBound(const Stretch& stretch) const {
    const double middle = 0.5 * (stretch.a.margin + stretch.b.margin - travelOf(stretch));
    return std::min({stretch.a.margin, stretch.b.margin, middle});
  }

  bool takeAsProved(const Stretch& stretch) {
    const double bound = lowerBound(stretch);
    const bool too_coarse =
        result_.tightest.margin - bound > options_.accuracy && travelOf(stretch) >= options_.least_travel;
    if (!(bound > 0) || too_coarse) return false;
    result_.proved_margin = std::min(result_.proved_margin, bound);
    return true;
  }

  Eigen::VectorXd postureAt(double s) const { return s == 1 ? q1_ : Eigen::VectorXd(q0_ + s * (q1_ - q0_)); }

  Sample sampleAt(double s) {
    Clearance clearance = clearance_of_(postureAt(s));
    ++result_.checks;
    const double margin = clearance.margin;
    if (result_.checks == 1 || !(margin >= result_.tightest.margin)) {
      result_.tightest = std::move(clearance);
      result_.where = s;
    }
    return {s, margin};
  }

  /// Whether a posture just met is in the way.
  bool isBlocked() {
    if (result_.tightest.margin >= 0) return false;
    blocked(describe(result_.tightest));
    return true;
  }

  MotionCheckResult blocked(std::string reason) {
    result_.status = MotionCheckStatus::kBlocked;
    result_.reason = std::move(reason);
    result_.proved_margin = std::numeric_limits<double>::quiet_NaN();
    return result_;
  }

  const Eigen::VectorXd &q0_, &q1_;
  const PostureClearance& clearance_of_;
  const double travel_;
  const MotionCheckOptions& options_;
  MotionCheckResult result_;
};

}  // namespace

MotionCheckResult checkMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                              const PostureClearance& clearance_of, const TravelBound& travel,
                              const MotionCheckOptions& options) {
  return MotionProof(q0, q1, clearance_of, travel, options).run();
}

}  // namespace tubeplan::planner
