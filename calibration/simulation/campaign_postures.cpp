#include "calibration/simulation/campaign_postures.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "deflection/inverse/inverse_kinematics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kNoiseMargin = 4;  // margin between a posture and its joint limits, in encoder sigmas

/// Accuracy of a start posture; the tip is brought exactly to its target later.
constexpr deflection::InverseKinematicsOptions kNear{.position_tolerance = 1e-5, .pitch_tolerance = 1e-4};

}  // namespace

const char* describe(PostureRefusal refusal) {
  switch (refusal) {
    case PostureRefusal::kNone:
      return "usable";
    case PostureRefusal::kNotConverged:
      return "without a deflected shape that converges";
    case PostureRefusal::kOutOfReach:
      return "out of reach";
    case PostureRefusal::kStretched:
      return "singular (stretched out or folded)";
    case PostureRefusal::kPastLimit:
      return "past a joint limit";
    case PostureRefusal::kOutsideRegion:
      return "with the tip outside the region";
    case PostureRefusal::kNotClear:
      return "in collision with the scene";
  }
  return "";
}

PostureSource::PostureSource(const deflection::Arm& arm, std::uint64_t seed)
    : arm_(arm), random_(seed, CampaignRandom::Stream::kPostures) {
  lower_.resize(arm.jointCount());
  upper_ = lower_;
  for (int k = 0; k < lower_.size(); ++k) {
    const auto& joint = arm.joint(k);
    std::tie(lower_[k], upper_[k]) = deflection::rangeOf(arm, joint);
    const double margin = std::min(kNoiseMargin * joint.encoder_sigma, (upper_[k] - lower_[k]) / 4);
    lower_[k] += margin;
    upper_[k] -= margin;
  }
}

Eigen::VectorXd PostureSource::randomPosture() {
  Eigen::VectorXd q(lower_.size());
  for (int k = 0; k < q.size(); ++k) q[k] = random_.uniform(lower_[k], upper_[k]);
  return q;
}

Eigen::Vector3d PostureSource::direction() {
  while (true) {
    const Eigen::Vector3d drawn(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
    const double length = drawn.norm();
    if (length > 0.1 && length <= 1) return drawn / length;
  }
}

HoleStart PostureSource::atHole(const CampaignSite& site, const std::vector<CampaignPoint>& holes,
                                const Eigen::Vector3d& axis_W, double below, double load) {
  HoleStart start;
  start.hole = holes[random_.index(static_cast<int>(holes.size()))];
  const deflection::ToolGoal goal{site.X_WB.inverse() * (start.hole.p_W - below * axis_W),
                                  site.X_WB.linear().transpose() * axis_W};
  const auto starts = deflection::isTurretArm(arm_) ? deflection::turretBranches(arm_, goal)
                                                    : std::vector<Eigen::VectorXd>{randomPosture()};
  start.refusal = PostureRefusal::kOutOfReach;
  if (starts.empty()) return start;
  const auto& from = starts[random_.index(static_cast<int>(starts.size()))];
  const auto branch = deflection::refineBranch(arm_, goal, load, site.gravity_B, from, kNear);
  start.q = branch.q;
  if (branch.status == deflection::BranchStatus::kConverged) start.refusal = PostureRefusal::kNone;
  if (branch.status == deflection::BranchStatus::kPastJointLimit) start.refusal = PostureRefusal::kPastLimit;
  if (branch.status == deflection::BranchStatus::kSingular) start.refusal = PostureRefusal::kStretched;
  return start;
}

bool PostureSource::isWithinLimits(const Eigen::VectorXd& q) const {
  for (int k = 0; k < q.size(); ++k) {
    const auto& joint = arm_.joint(k);
    const bool bounded = std::isfinite(joint.lower) || std::isfinite(joint.upper);
    if (bounded && (q[k] < lower_[k] || q[k] > upper_[k])) return false;
  }
  return true;
}

}  // namespace tubeplan::calibration
