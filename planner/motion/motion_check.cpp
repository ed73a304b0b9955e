#include "planner/motion/motion_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "planner/motion/side_by_side.hpp"

namespace tubeplan::planner {
namespace {

constexpr std::size_t kLanes = 8;          // largest number of kernel lanes on any processor
constexpr std::size_t kMostTogether = 64;  // largest number of postures computed together; those after a blocked
                                           // posture are wasted

struct Sample {
  double s;       ///< position along the motion, from 0 to 1
  double margin;  ///< margin at `s` [m]
};

/// A position along the motion with the full clearance of its posture.
struct Named {
  double s;
  Clearance clearance;
};

struct Stretch {
  Sample a, b;
};

class MotionProof {
 public:
  MotionProof(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const PostureClearance& clearance_of,
              const TravelBound& travel, const MotionCheckOptions& options)
      : q0_(q0),
        q1_(q1),
        clearance_of_(clearance_of),
        side_by_side_(clearance_of.target<SideBySideClearance>()),
        travel_(travel(q0, q1)),
        options_(options) {}

  MotionCheckResult run() {
    if (travel_ > 0) computeMargins({0, 1});
    prove();
    nameTightest();
    return result_;
  }

 private:
  void prove() {
    const Sample start = sampleAt(0), goal = travel_ > 0 ? sampleAt(1) : start;
    if (isBlocked()) return;
    result_.proved_margin = std::min(start.margin, goal.margin);
    // Breadth first, because a blocked motion is usually found within the first few bisections.
    std::deque<Stretch> open;
    if (travel_ > 0) open.push_back({start, goal});
    for (std::size_t batch = 0; !open.empty(); --batch) {
      if (batch == 0) {
        batch = std::min(open.size(), kMostTogether);
        computeMiddleMargins(open, batch);
      }
      const Stretch stretch = open.front();
      open.pop_front();
      if (takeAsProved(stretch)) continue;
      if (travelOf(stretch) < options_.least_travel) return block("clearance too small to prove: ");
      if (result_.checks >= options_.max_checks)
        return block(fmt::format("not proved free in {} postures: ", result_.checks));
      const Sample middle = sampleAt(middleOf(stretch));
      if (isBlocked()) return;
      open.push_back({stretch.a, middle});
      open.push_back({middle, stretch.b});
    }
    result_.status = MotionCheckStatus::kFree;
  }

  static double middleOf(const Stretch& stretch) { return 0.5 * (stretch.a.s + stretch.b.s); }

  double travelOf(const Stretch& stretch) const { return travel_ * (stretch.b.s - stretch.a.s); }

  /// Returns a lower bound on the margin along the segment, at the point where the bounds from its two ends intersect.
  double lowerBound(const Stretch& stretch) const {
    const double middle = 0.5 * (stretch.a.margin + stretch.b.margin - travelOf(stretch));
    return std::min({stretch.a.margin, stretch.b.margin, middle});
  }

  [[nodiscard]] bool isProved(const Stretch& stretch, double bound) const {
    const bool too_coarse =
        result_.tightest.margin - bound > options_.accuracy && travelOf(stretch) >= options_.least_travel;
    return bound > 0 && !too_coarse;
  }

  bool takeAsProved(const Stretch& stretch) {
    const double bound = lowerBound(stretch);
    if (!isProved(stretch, bound)) return false;
    result_.proved_margin = std::min(result_.proved_margin, bound);
    return true;
  }

  /// Computes the margins at several positions in advance. This affects only the speed, not the results.
  void computeMargins(const std::vector<double>& places) {
    if (!side_by_side_ || places.size() < 2) return;
    PostureColumns q(q0_.size(), static_cast<Eigen::Index>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k) q.col(static_cast<Eigen::Index>(k)) = postureAt(places[k]);
    MarginsSideBySide found = side_by_side_->many(q);
    for (std::size_t k = 0; k < places.size(); ++k) known_.push_back({places[k], found.margins[k]});
    named_.push_back({places[found.tightest], std::move(found.clearance)});
  }

  /// Computes the margins at the midpoints of the next segments to be bisected. Unused lanes compute the midpoints of
  /// halves that will probably be bisected again.
  void computeMiddleMargins(const std::deque<Stretch>& open, std::size_t count) {
    if (!side_by_side_) return;
    std::vector<double> places, further;
    std::vector<Sample> kept;
    for (std::size_t k = 0; k < count; ++k) {
      const Stretch& stretch = open[k];
      const double middle = middleOf(stretch);
      if (isProved(stretch, lowerBound(stretch))) continue;
      if (const Sample* known = findKnown(middle))
        kept.push_back(*known);
      else
        places.push_back(middle);
      if (!halvesWillDo(stretch))
        further.insert(further.end(), {0.5 * (stretch.a.s + middle), 0.5 * (middle + stretch.b.s)});
    }
    known_ = std::move(kept);
    if (!places.empty() && places.size() + further.size() <= kLanes)
      places.insert(places.end(), further.begin(), further.end());
    computeMargins(places);
  }

  /// Returns true if both halves would be proved, assuming that the margin at the midpoint is the mean of the margins
  /// at the two ends.
  [[nodiscard]] bool halvesWillDo(const Stretch& stretch) const {
    const Sample middle{middleOf(stretch), 0.5 * (stretch.a.margin + stretch.b.margin)};
    return isProved({stretch.a, middle}, middle.margin - 0.25 * travelOf(stretch));
  }

  [[nodiscard]] const Sample* findKnown(double s) const {
    const auto found = std::ranges::find(known_, s, &Sample::s);
    return found == known_.end() ? nullptr : &*found;
  }

  Eigen::VectorXd postureAt(double s) const { return s == 1 ? q1_ : Eigen::VectorXd(q0_ + s * (q1_ - q0_)); }

  Sample sampleAt(double s) {
    Clearance clearance;
    const Sample* known = findKnown(s);
    if (known)
      clearance.margin = known->margin;
    else
      clearance = clearance_of_(postureAt(s));
    ++result_.checks;
    const double margin = clearance.margin;
    if (result_.checks == 1 || !(margin >= result_.tightest.margin)) {
      result_.tightest = std::move(clearance);
      result_.where = s;
      is_named_ = !known;
    }
    return {s, margin};
  }

  void nameTightest() {
    if (is_named_) return;
    const auto named = std::ranges::find(named_, result_.where, &Named::s);
    result_.tightest = named == named_.end() ? clearance_of_(postureAt(result_.where)) : named->clearance;
    is_named_ = true;
  }

  /// Returns true, and records the result, if the smallest margin so far is negative or NaN.
  bool isBlocked() {
    if (result_.tightest.margin >= 0) return false;
    block("");
    return true;
  }

  void block(const std::string& why) {
    nameTightest();
    result_.status = MotionCheckStatus::kBlocked;
    result_.reason = why + describe(result_.tightest);
    result_.proved_margin = std::numeric_limits<double>::quiet_NaN();
  }

  const Eigen::VectorXd &q0_, &q1_;
  const PostureClearance& clearance_of_;
  /// `clearance_of_` for several postures at once; null if `clearance_of_` is not a SideBySideClearance.
  const SideBySideClearance* side_by_side_;
  const double travel_;
  const MotionCheckOptions& options_;
  std::vector<Sample> known_;  ///< margins computed in advance
  std::vector<Named> named_;   ///< the tightest posture of each batch
  bool is_named_ = true;       ///< true if `tightest` includes the names of its pair as well as the margin
  MotionCheckResult result_;
};

}  // namespace

MotionCheckResult checkMotion(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                              const PostureClearance& clearance_of, const TravelBound& travel,
                              const MotionCheckOptions& options) {
  return MotionProof(q0, q1, clearance_of, travel, options).run();
}

}  // namespace tubeplan::planner
