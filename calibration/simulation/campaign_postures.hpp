// Start postures of a campaign's measurements, and the required positions of the tip.
#pragma once

#include <string>
#include <vector>

#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// A named point in the world frame [m].
struct CampaignPoint {
  std::string name;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
};

/// Name and pose of the base in one set-up, with the direction of gravity in the base frame.
struct CampaignSite {
  int setup = 0;
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d gravity_B = -Eigen::Vector3d::UnitZ();
};

/// Reason why a random posture is unusable.
enum class PostureRefusal { kNone, kNotConverged, kOutOfReach, kStretched, kPastLimit, kOutsideRegion, kNotClear };
inline constexpr int kPostureRefusals = 7;

/// Returns a phrase such as "past a joint limit", which completes "1400 of the postures were ...".
[[nodiscard]] const char* describe(PostureRefusal refusal);

/// A start posture at a hole; usable only if `refusal` is kNone.
struct HoleStart {
  PostureRefusal refusal = PostureRefusal::kNone;
  CampaignPoint hole;
  Eigen::VectorXd q;
};

/// Generator of random postures of one arm; the same seed gives the same series.
class PostureSource {
 public:
  PostureSource(const deflection::Arm& arm, std::uint64_t seed);

  /// Returns a random posture within the joint limits, with a margin for noisy measurements. Joints without limits
  /// range over half a turn on either side of zero, prismatic ones over the arm's reach.
  [[nodiscard]] Eigen::VectorXd randomPosture();

  /// Returns a random unit vector; all directions are equally likely.
  [[nodiscard]] Eigen::Vector3d direction();

  /// Returns one of the arm's postures at a random hole, with the tool along the axis and the tip a distance `below`
  /// [m] under the hole.
  [[nodiscard]] HoleStart atHole(const CampaignSite& site, const std::vector<CampaignPoint>& holes,
                                 const Eigen::Vector3d& axis_W, double below, double load);

  [[nodiscard]] bool isWithinLimits(const Eigen::VectorXd& q) const;

 private:
  const deflection::Arm& arm_;
  Eigen::VectorXd lower_, upper_;
  CampaignRandom random_;
};

}  // namespace tubeplan::calibration
