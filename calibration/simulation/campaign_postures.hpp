// Postures to begin a campaign's readings from, and the places where the tip then has to be.
#pragma once

#include <string>
#include <vector>

#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// A place in the world, by name.
struct CampaignPoint {
  std::string name;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
};

/// The base as it stands in one set-up.
struct CampaignSite {
  int setup = 0;
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d gravity_B = -Eigen::Vector3d::UnitZ();
};

/// Why a posture drawn at random is of no use.
enum class PostureRefusal { kNone, kNotConverged, kOutOfReach, kStretched, kPastLimit, kOutsideRegion, kNotClear };
inline constexpr int kPostureRefusals = 7;

/// "past a joint limit"; continues "so many of the postures were ...".
[[nodiscard]] const char* describe(PostureRefusal refusal);

/// A posture at a hole, to begin a reading from.
struct HoleStart {
  PostureRefusal refusal = PostureRefusal::kNone;
  CampaignPoint hole;
  Eigen::VectorXd q;
};

/// Random postures of one arm, the same series for a seed.
class PostureSource {
 public:
  PostureSource(const deflection::Arm& arm, std::uint64_t seed);

  /// Anywhere within the limits, so far from them that a noisy reading stays within; half a turn each way where there
  /// are none, the arm's reach for a slide.
  [[nodiscard]] Eigen::VectorXd anywhere();

  /// A unit vector, all directions alike.
  [[nodiscard]] Eigen::Vector3d direction();

  /// One of the arm's postures at one of the holes, the tool along the axis and the tip short of the hole by `below`
  /// [m].
  [[nodiscard]] HoleStart atHole(const CampaignSite& site, const std::vector<CampaignPoint>& holes,
                                 const Eigen::Vector3d& axis_W, double below, double load);

  [[nodiscard]] bool isWithinLimits(const Eigen::VectorXd& q) const;

 private:
  const deflection::Arm& arm_;
  Eigen::VectorXd lower_, upper_;
  CampaignRandom random_;
};

}  // namespace tubeplan::calibration
