// The readings of one point or posture of a simulated campaign, taken by the true arm under one load after the other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"
#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_options.hpp"
#include "calibration/simulation/campaign_postures.hpp"

namespace tubeplan::calibration {

/// Usable only where nothing refused them.
struct StationReadings {
  PostureRefusal refusal = PostureRefusal::kNone;
  std::string name;                    ///< of the point or posture: P1, H1, R10C20
  std::optional<Eigen::Vector3d> p_W;  ///< m, the point that is touched or looked at
  std::optional<Surface> surface;      ///< that is touched, of kinds that do
  std::vector<Measurement> readings;
  std::vector<Eigen::Vector3d> tips_W;  ///< m, of each reading, without noise
};

/// Where the tool is in a posture, if that is of use.
struct TipTrial {
  PostureRefusal refusal = PostureRefusal::kNone;
  ToolPose tool;
};

/// The true arm at work. It remembers where it is, for the sense in which its joints arrive at the next posture. What
/// it is given must outlive it.
class CampaignStation {
 public:
  CampaignStation(const deflection::Arm& arm, const CampaignDesign& design, const CampaignOptions& options);

  /// One draw for the point or posture of that number (from 1): as many readings as there are conditions. A hole that
  /// was read is not drawn again.
  [[nodiscard]] StationReadings read(const CampaignSite& site, int number,
                                     const std::vector<ReadingConditions>& conditions);

  /// From now on all holes may be drawn once more.
  void renewHoles() { fresh_holes_ = options_.holes; }

  /// A posture drawn at random under the first load.
  [[nodiscard]] TipTrial tryAnywhere(const CampaignSite& site);

  /// m against gravity, in the world, of designs in a plane.
  void setPlaneHeight(double height) { plane_height_ = height; }

 private:
  /// Draws the posture to begin from, and for the first posture of a point the point.
  [[nodiscard]] PostureRefusal begin(const CampaignSite& site, StationReadings& taken, Eigen::VectorXd& q);
  [[nodiscard]] PostureRefusal beginAtSurface(const CampaignSite& site, StationReadings& taken, Eigen::VectorXd& q);
  [[nodiscard]] PostureRefusal beginAtHole(const CampaignSite& site, StationReadings& taken, Eigen::VectorXd& q);

  /// Brings the arm from `here` to the reading's place and reads it there, without the encoders' noise.
  [[nodiscard]] PostureRefusal take(const CampaignSite& site, const ReadingConditions& conditions,
                                    const StationReadings& taken, const Eigen::VectorXd& here, Measurement& reading,
                                    Eigen::Vector3d& tip_W) const;
  [[nodiscard]] PostureRefusal bringTip(const CampaignSite& site, const ReadingConditions& conditions,
                                        const Eigen::Vector3d& goal_W, const Eigen::VectorXd& here,
                                        Measurement& reading) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> goalOf(const CampaignSite& site, const StationReadings& taken,
                                                      const Measurement& reading, const Eigen::Vector3d& noise) const;
  [[nodiscard]] TipTrial check(const CampaignSite& site, const Measurement& reading) const;
  [[nodiscard]] bool isInRegion(const CampaignSite& site, const Eigen::Vector3d& tip_W) const;

  const deflection::Arm& arm_;
  const CampaignDesign& design_;
  const CampaignOptions& options_;
  PostureSource source_;
  double reach_, plane_height_ = 0;
  std::vector<CampaignPoint> fresh_holes_;  ///< not read yet
  Eigen::VectorXd here_;                    ///< the last posture's readings, without noise
};

}  // namespace tubeplan::calibration
