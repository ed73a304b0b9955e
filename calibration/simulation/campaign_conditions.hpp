// Conditions of a simulated measurement: time, stated conditions, the direction from which each joint arrived, and
// noise.
#pragma once

#include "calibration/measurement.hpp"
#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

struct CampaignPace {
  double shortest = 60, longest = 180;  ///< smallest and largest time between two measurements [s]
  /// Longest period of the conditions' oscillations [s]; it is shortened so that a campaign covers about half a period
  /// or more.
  double longest_period = 28800;
  double overshoot = 0.5;  ///< probability that a joint passes its goal and returns to it
};

/// Conditions of one measurement, drawn before its posture is known.
struct MeasurementConditions {
  deflection::ConditionValues stated;  ///< stated conditions; time counts from the start of the campaign
  /// Arrival of each joint: +1 if the joint stops at its goal, -1 if it passes the goal and returns.
  std::vector<int> turns;
  std::vector<int> rests;  ///< stated direction of each joint's last motion if the joint does not move
  Eigen::Vector3d coordinate_noise = Eigen::Vector3d::Zero();  ///< noise of the coordinates [m]
  Eigen::Vector3d turn_noise = Eigen::Vector3d::Zero();        ///< noise of the angles [rad]
  Eigen::VectorXd encoder_noise;                               ///< noise of the joint readings [rad or m]
  Eigen::VectorXd side_q;                                      ///< positions of the side chains' joints [rad or m]
  Eigen::Vector3d push = Eigen::Vector3d::Zero();              ///< additional force on the tip, in world axes [N]

  /// Returns the sign of each joint's last motion on the way between two postures.
  [[nodiscard]] std::vector<int> approach_directions(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
};

/// Generator of the conditions of successive measurements, in order of time.
class ConditionSeries {
 public:
  ConditionSeries(const deflection::Arm& arm, const CampaignPace& pace, int measurements, const CampaignDesign& design,
                  std::uint64_t seed);

  [[nodiscard]] MeasurementConditions next();

 private:
  void drawConditions(deflection::ConditionValues& stated);

  CampaignPace pace_;
  Eigen::Matrix3d noise_factor_;
  double turn_sigma_, push_, period_, time_ = 0;
  deflection::ConditionValues usual_, phases_;
  std::vector<double> encoder_sigmas_;
  std::vector<std::pair<double, double>> side_limits_;
  bool is_first_ = true;
  CampaignRandom conditions_, noise_, pushes_, side_chains_;
};

}  // namespace tubeplan::calibration
