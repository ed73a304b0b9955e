// The measurements of one point or posture of a simulated campaign, taken with the true arm under one load after
// another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"
#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_options.hpp"
#include "calibration/simulation/campaign_postures.hpp"

namespace tubeplan::calibration {

/// Measurements of a point or posture; usable only if `refusal` is kNone.
struct StationMeasurements {
  PostureRefusal refusal = PostureRefusal::kNone;
  std::string name;                    ///< name of the point or posture, such as P1, H1 or R10C20
  std::optional<Eigen::Vector3d> p_W;  ///< position of the touched or measured point in the world frame [m]
  std::optional<Surface> surface;      ///< touched surface, for kinds that touch a surface
  std::vector<Measurement> measurements;
  std::vector<Eigen::Vector3d> tips_W;  ///< tip position at each measurement, in the world frame, without noise [m]
};

/// Pose of the tool in a posture; valid only if `refusal` is kNone.
struct TipTrial {
  PostureRefusal refusal = PostureRefusal::kNone;
  ToolPose tool;
};

/// Simulated measurements with the true arm. The last posture is stored, because it determines from which direction the
/// joints arrive at the next one. The constructor's arguments must outlive this object.
class CampaignStation {
 public:
  CampaignStation(const deflection::Arm& arm, const CampaignDesign& design, const CampaignOptions& options);

  /// Makes one attempt to draw the point or posture with the number `number` (from 1), and takes one measurement there
  /// under each of the conditions. A hole that has been measured is not drawn again.
  [[nodiscard]] StationMeasurements read(const CampaignSite& site, int number,
                                         const std::vector<MeasurementConditions>& conditions);

  /// Allows holes that have been measured to be drawn again.
  void renewHoles() { fresh_holes_ = options_.holes; }

  /// Draws a random posture, and returns the pose of the tool in it under the first load.
  [[nodiscard]] TipTrial tryRandomPosture(const CampaignSite& site);

  /// For designs in a plane: sets the height of the plane [m], measured against gravity in the world frame.
  void setPlaneHeight(double height) { plane_height_ = height; }

 private:
  /// Draws the start posture; for the first posture of a point, draws the point too.
  [[nodiscard]] PostureRefusal begin(const CampaignSite& site, StationMeasurements& taken, Eigen::VectorXd& q);
  [[nodiscard]] PostureRefusal beginAtSurface(const CampaignSite& site, StationMeasurements& taken, Eigen::VectorXd& q);
  [[nodiscard]] PostureRefusal beginAtHole(const CampaignSite& site, StationMeasurements& taken, Eigen::VectorXd& q);

  /// Moves the arm from the joint values `q_before` to the measurement's target and takes the measurement there,
  /// without encoder noise.
  [[nodiscard]] PostureRefusal take(const CampaignSite& site, const MeasurementConditions& conditions,
                                    const StationMeasurements& taken, const Eigen::VectorXd& q_before,
                                    Measurement& measurement, Eigen::Vector3d& tip_W) const;
  [[nodiscard]] PostureRefusal bringTip(const CampaignSite& site, const MeasurementConditions& conditions,
                                        const Eigen::Vector3d& goal_W, const Eigen::VectorXd& q_before,
                                        Measurement& measurement) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> goalOf(const CampaignSite& site, const StationMeasurements& taken,
                                                      const Measurement& measurement,
                                                      const Eigen::Vector3d& noise) const;
  [[nodiscard]] TipTrial check(const CampaignSite& site, const Measurement& measurement) const;
  [[nodiscard]] bool isInRegion(const CampaignSite& site, const Eigen::Vector3d& tip_W) const;

  const deflection::Arm& arm_;
  const CampaignDesign& design_;
  const CampaignOptions& options_;
  PostureSource source_;
  double reach_, plane_height_ = 0;
  std::vector<CampaignPoint> fresh_holes_;  ///< holes that have not been measured yet
  Eigen::VectorXd last_q_;                  ///< joint values of the last posture, without noise
};

}  // namespace tubeplan::calibration
