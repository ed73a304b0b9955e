// Start postures of a campaign's readings, and the places required of the tip.
#pragma once

#include <string>
#include <vector>

#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// A named place in the world [m].
struct CampaignPoint {
  std::string name;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
};

/// The base in one set-up.
struct CampaignSite {
  int setup = 0;
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d gravity_B = -Eigen::Vector3d::UnitZ();
};

/// Reason why a random posture is unusable.
enum class PostureRefusal { kNone, kNotConverged, kOutOfReach, kStretched, kPastLimit, kOutsideRegion, kNotClear };
inline constexpr int kPostureRefusals = 7;

/// Returns "past a joint limit", to follow "so many of the postures were ...".
[[nodiscard]] const char* describe(PostureRefusal refusal);

/// A start posture at a hole.
struct HoleStart {
  PostureRefusal refusal = PostureRefusal::kNone;
  CampaignPoint hole;
  Eigen::VectorXd q;
};

/// Random postures of one arm, the same series for a seed.
class PostureSource {
 public:
  PostureSource(const deflection::Arm& arm, std::uint64_t seed);

  /// Returns a posture anywhere within the limits, so far from them that a noisy reading stays within; half a turn each
  /// way without limits, the arm's reach for a slide.
  [[nodiscard]] Eigen::VectorXd anywhere();

  /// Returns a unit vector, with all directions equally likely.
  [[nodiscard]] Eigen::Vector3d direction();

  /// Returns one of the arm's postures at one of the holes, with the tool along the axis and the tip `below` [m] under
  /// the hole.
  [[nodiscard]] HoleStart atHole(const CampaignSite& site, const std::vector<CampaignPoint>& holes,
                                 const Eigen::Vector3d& axis_W, double below, double load);

  [[nodiscard]] bool isWithinLimits(const Eigen::VectorXd& q) const;

 private:
  const deflection::Arm& arm_;
  Eigen::VectorXd lower_, upper_;
  CampaignRandom random_;
};

}  // namespace tubeplan::calibration
